#pragma once

#include "runtime/carrier.hpp"
#include "runtime/event.hpp"
#include "runtime/link_timing.hpp"
#include "runtime/wire.hpp"

#include <source_location>

namespace placedpar {

class Kernel;
class Process;

/// One direction of a link, for one message at a time: the two engines that the instructions `out` and `in`
/// start at its ends. A sender goes on when the acknowledge of its last byte has come, a receiver when its
/// last byte has. The first byte of a message that nobody has asked for waits, unacknowledged, at the
/// receiving end. Each byte is simulated; the times are exact to the bit.
class LinkDirection final : public Carrier, private WireUser {
public:
    /// Its bytes travel on `out`, their acknowledges on `back`.
    LinkDirection(Kernel&, const LinkTiming&, Wire& out, Wire& back);

    void output(AnyChannel&, const WireForm&, const std::source_location&) override;
    void input(AnyChannel&, const std::source_location&) override;
    bool message_waits(const AnyChannel&) const override { return first_byte_waits_; }

    std::uint64_t bytes_carried() const { return bytes_carried_; }
    /// How long messages were under way, from the start of their first byte to the acknowledge of the last.
    Time time_occupied() const { return time_occupied_; }

private:
    void send(std::uint32_t bytes, bool last_part, const std::source_location&);
    bool receive(const std::source_location&);

    // What happens to a byte, in this order.
    void start_byte();
    void byte_started() override;
    void byte_noticed();
    void first_byte_arrived();
    void last_byte_arrived(std::uint32_t part);
    void acknowledge_started() override;
    void sending_ended();
    void take_part();

    template <void (LinkDirection::*Step)()>
    struct StepEvent final : Event {
        StepEvent(LinkDirection& d) : direction(d) {}
        void happen() noexcept override { (direction.*Step)(); }
        LinkDirection& direction;
    };
    struct LastByte final : Event {
        LastByte(LinkDirection& d) : direction(d) {}
        void happen() noexcept override { direction.last_byte_arrived(part); }
        LinkDirection& direction;
        std::uint32_t part = 0;
    };
    void schedule(Event&, Time);

    Kernel& kernel_;
    const LinkTiming& timing_;
    Wire& out_;
    Wire& back_;
    AnyChannel* channel_ = nullptr; ///< of the message under way

    Process* sender_ = nullptr;
    std::uint32_t part_ = 0; ///< counts the parts sent
    std::uint32_t bytes_in_part_ = 0;
    std::uint32_t bytes_left_ = 0; ///< not yet started
    bool last_part_ = false;
    Time may_start_{}; ///< no byte before this
    Time began_{};

    Process* receiver_ = nullptr;
    bool first_byte_waits_ = false; ///< arrived, and nobody has asked for it
    bool acknowledge_owed_ = false; ///< to the first byte, once somebody asks for it
    bool taken_ = false;            ///< the receiver is sure to get all of the part
    bool took_last_part_ = false;

    StepEvent<&LinkDirection::start_byte> start_byte_{*this};
    StepEvent<&LinkDirection::byte_noticed> byte_noticed_{*this};
    StepEvent<&LinkDirection::first_byte_arrived> first_byte_arrived_{*this};
    /// Two, for the sender can begin its next part before the last byte of this one has arrived.
    LastByte last_byte_arrived_[2]{*this, *this};
    StepEvent<&LinkDirection::sending_ended> sending_ended_{*this};

    std::uint64_t bytes_carried_ = 0;
    Time time_occupied_{};
};

/// A link: two wires, each carrying the bytes of one direction and the acknowledges of the other.
class Link {
public:
    Link(Kernel&, const LinkTiming&);
    Link(const Link&) = delete;
    Link& operator=(const Link&) = delete;

    LinkDirection& from_a_to_b() { return a_to_b_; }
    LinkDirection& from_b_to_a() { return b_to_a_; }
    const LinkDirection& from_a_to_b() const { return a_to_b_; }
    const LinkDirection& from_b_to_a() const { return b_to_a_; }

private:
    LinkTiming timing_;
    Wire wire_from_a_, wire_from_b_;
    LinkDirection a_to_b_, b_to_a_;
};

} // namespace placedpar
