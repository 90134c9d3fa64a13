#pragma once

#include "runtime/carrier.hpp"
#include "runtime/event.hpp"
#include "runtime/hardware/link_timing.hpp"
#include "runtime/hardware/wire.hpp"
#include "runtime/source_location.hpp"

#include <string>

namespace placedpar {
class Kernel;
class Process;
} // namespace placedpar

namespace placedpar::hardware {

/// One direction of a link, for the messages of one channel: the two engines that the instructions `out` and
/// `in` start at its ends. A sender goes on when the acknowledge of its last byte has arrived, a receiver when
/// the last byte has. If no process has asked for a message, its first byte waits, unacknowledged, at the receiving
/// end. The times are exact to the bit.
///
/// Throws std::logic_error when a second channel uses it, and for a message without bytes.
class LinkDirection final : public Carrier, private WireUser {
public:
    /// Its bytes travel on `out`, their acknowledges on `back`; `opposite` uses them the other way round.
    LinkDirection(Kernel&, std::string name, const LinkTiming&, Wire& out, Wire& back, LinkDirection& opposite);

    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override { return first_byte_waits_; }

    /// Simulates every byte by events, without the closed form: the reference by which the closed form is tested.
    void simulate_every_byte() { every_byte_ = true; }

    /// "t[0].link[1] -> t[1].link[0]"
    const std::string& name() const { return name_; }
    /// Those that the wire has begun to carry.
    std::uint64_t bytes_carried() const { return bytes_carried_ - skipped_bytes_ + skipped_bytes_started(); }
    /// How long the wire has carried their bits.
    Time time_occupied() const;

private:
    void serve(AnyChannel&);
    void send(std::uint32_t bytes, bool last_part, const SourceLocation&);
    bool receive(const SourceLocation&);

    // What happens to a byte, in this order.
    void start_byte();
    void byte_started() override;
    void byte_noticed();
    void first_byte_arrived();
    void last_byte_arrived();
    void acknowledge_started() override;
    void sending_ended();
    void take_part();

    // For the trace.
    void trace_bytes(Time since);
    void trace_break(Time byte_started);

    // The closed form (link_closed_form.cpp).
    /// Whether it will use neither wire until a process acts.
    bool quiet() const { return !sender_ || acknowledge_owed_; }
    bool quiet_enough_to_skip() const { return !every_byte_ && bytes_left_ > 2 && opposite_.quiet(); }
    void skip_middle_bytes();
    std::uint32_t skipped_bytes_started() const;
    void simulate_bytes_again();

    template <void (LinkDirection::*Step)(), EventQueue::Priority priority, std::uint64_t number>
    struct StepEvent final : Event {
        StepEvent(LinkDirection& d) : direction(d) {}
        void happen() noexcept override { (direction.*Step)(); }
        void schedule(Time at) { direction.schedule(*this, at, priority, number); }
        LinkDirection& direction;
    };
    void schedule(Event&, Time, EventQueue::Priority, std::uint64_t number);
    void cancel(Event&);

    Kernel& kernel_;
    std::string name_;
    const LinkTiming& timing_;
    Wire& out_;
    Wire& back_;
    LinkDirection& opposite_;
    AnyChannel* channel_ = nullptr; ///< whose messages it carries

    Process* sender_ = nullptr; ///< from the start of a part to the acknowledge of its last byte
    std::uint32_t bytes_in_part_ = 0;
    std::uint32_t bytes_left_ = 0; ///< not yet started
    bool last_part_ = false;       ///< the part under way ends its message
    Time may_start_{};             ///< no byte before this

    Process* receiver_ = nullptr;
    bool first_byte_waits_ = false; ///< it has arrived, and no process has asked for it
    bool acknowledge_owed_ = false; ///< to the first byte, once a process asks for it
    /// The receiver has been given the part, and either its last byte or that byte's acknowledge is still to come.
    bool taken_ = false;
    bool took_last_part_ = false; ///< the part that was taken last ended its message

    bool every_byte_ = false;
    std::uint32_t skipped_bytes_ = 0; ///< bytes of the part under way that the closed form stands for
    Time first_skipped_start_{};
    Time last_start_{}; ///< of the bytes before those

    StepEvent<&LinkDirection::start_byte, EventQueue::start, 1> start_byte_{*this};
    StepEvent<&LinkDirection::byte_noticed, EventQueue::request, 1> byte_noticed_{*this};
    StepEvent<&LinkDirection::first_byte_arrived, EventQueue::arrival, 1> first_byte_arrived_{*this};
    /// Two, since on a long wire the next part can start before the last byte of this one has arrived.
    StepEvent<&LinkDirection::last_byte_arrived, EventQueue::arrival, 2> last_byte_arrived_[2]{*this, *this};
    StepEvent<&LinkDirection::sending_ended, EventQueue::arrival, 3> sending_ended_{*this};

    std::uint64_t bytes_carried_ = 0;
    std::uint64_t bytes_traced_ = 0; ///< of them, how many the trace was told of
    bool trace_carries_ = false;     ///< the trace was told that bytes follow each other
};

/// A link: two wires, each carrying the bytes of one direction and the acknowledges of the other.
class Link {
public:
    /// The names are those of its ends, for reports. Throws std::logic_error unless bits_per_second > 0 and the wire's
    /// delay is not negative.
    explicit Link(Kernel&, const LinkTiming& = {}, const std::string& a = "a", const std::string& b = "b");
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

} // namespace placedpar::hardware
