#pragma once

#include "runtime/event.hpp"
#include "runtime/hardware/link_timing.hpp"

namespace placedpar {

class Kernel;

/// How many kinds of events share the rank of a wire: its own, and those of the bytes that it carries.
constexpr std::uint64_t events_of_a_wire = 4;

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
/// after the other. An acknowledge goes before a byte that waits as well.
class Wire {
public:
    Wire(Kernel&, const LinkTiming&);

    std::uint64_t rank() const { return rank_; }
    /// The end of the packet that it carries or carried last.
    Time free_at() const { return free_at_; }
    /// For packets that were not simulated one by one.
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
    std::uint64_t rank_;
    Time free_at_{};
    WireUser* byte_for_ = nullptr;
    WireUser* acknowledge_for_ = nullptr;
    Freed freed_{*this};
};

} // namespace placedpar
