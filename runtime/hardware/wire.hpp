#pragma once

#include "runtime/event.hpp"
#include "runtime/hardware/link_timing.hpp"

namespace placedpar {
class Kernel;
} // namespace placedpar

namespace placedpar::hardware {

/// How many ranks a wire needs for its events: one for its own event, three for the events of the bytes that it
/// carries.
constexpr std::uint64_t ranks_of_a_wire = 4;

/// A direction of a link, as one of the two users of a wire.
class WireUser {
public:
    /// The wire has begun to carry this direction's byte, or its acknowledge.
    virtual void byte_started() = 0;
    virtual void acknowledge_started() = 0;

protected:
    ~WireUser() = default;
};

/// One wire of a link: it carries the bytes of one direction and the acknowledges of the other, one packet
/// after the other. If both wait, the acknowledge goes first.
class Wire {
public:
    Wire(Kernel&, const LinkTiming&);

    /// Of its events. The three ranks after it are for the direction whose bytes it carries.
    std::uint64_t first_rank() const { return first_rank_; }
    /// The end of the packet that it carries or carried last.
    Time free_at() const { return free_at_; }
    /// Notes packets that were not simulated one by one.
    void occupied_until(Time time) { free_at_ = std::max(free_at_, time); }

    void ask_for_byte(WireUser& user) {
        byte_for_ = &user;
        serve();
    }
    void ask_for_acknowledge(WireUser& user) {
        acknowledge_for_ = &user;
        serve();
    }

private:
    struct Freed final : Event {
        explicit Freed(Wire& w) : wire(w) {}
        void happen() noexcept override { wire.serve(); }
        Wire& wire;
    };
    void serve();

    Kernel& kernel_;
    const LinkTiming& timing_;
    std::uint64_t first_rank_;
    Time free_at_{};
    WireUser* byte_for_ = nullptr;        ///< the direction that waits to send a byte
    WireUser* acknowledge_for_ = nullptr; ///< the direction that waits to send an acknowledge
    Freed freed_{*this};
};

} // namespace placedpar::hardware
