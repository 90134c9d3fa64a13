#pragma once

#include "runtime/hardware/link_agenda.hpp"
#include "runtime/hardware/link_timing.hpp"

#include <cstddef>
#include <cstdint>

namespace placedpar::hardware {

/// A direction of a link, as one of the two users of a wire.
class WireUser {
public:
    /// The wire has begun to carry this direction's byte, or its acknowledge.
    virtual void byte_started() = 0;
    virtual void acknowledge_started() = 0;

protected:
    ~WireUser() = default;
};

/// Is told when a wire is about to begin a packet: the owner of a link that has faults, which may change its speed.
class WireWatch {
public:
    virtual void packet_begins() = 0;

protected:
    ~WireWatch() = default;
};

/// One wire of a link: it carries the bytes of one direction and the acknowledges of the other, one packet
/// after the other. If both wait, the acknowledge goes first.
class alignas(64) Wire {
public:
    /// That of the bytes of direction 0 or 1.
    Wire(Kernel&, LinkAgenda&, const PacketTimes&, std::size_t number);

    /// The end of the packet that it carries or carried last.
    Time free_at() const { return free_at_; }
    /// It is another moment for it: the end of the packet that it carries then, and who waits for that.
    void go_to(Time free_at, WireUser* byte_for, WireUser* acknowledge_for);
    /// Whose turn it is, if it is free.
    void serve();
    /// Enters its next step in the agenda, if anybody waits for it. One that stands there for nobody stays (withdraw).
    void plan();

    void watch(WireWatch& watch) { watch_ = &watch; }

    void ask_for_byte(WireUser& user) {
        byte_for_ = &user;
        serve();
    }
    void ask_for_acknowledge(WireUser& user) {
        acknowledge_for_ = &user;
        serve();
    }
    /// Whether the direction's byte or acknowledge has been asked for, and has yet to begin.
    bool byte_waits(const WireUser& user) const { return byte_for_ == &user; }
    bool acknowledge_waits(const WireUser& user) const { return acknowledge_for_ == &user; }
    /// A direction does not want to send after all what has not begun yet. Whose packet was due leaves the step at
    /// which the wire is free: it comes, though nobody waits any more, and may be the last of a run that gets stuck.
    /// Who asked early, before that, leaves nothing behind.
    void withdraw_byte(bool has_asked_early) { withdraw(byte_for_, has_asked_early); }
    void withdraw_acknowledge(bool has_asked_early) { withdraw(acknowledge_for_, has_asked_early); }

private:
    void withdraw(WireUser*&, bool has_asked_early);

    // What each packet needs first: in a line of the cache.
    Time free_at_{};
    WireUser* byte_for_ = nullptr;        ///< the direction that waits to send a byte
    WireUser* acknowledge_for_ = nullptr; ///< the direction that waits to send an acknowledge
    LinkAgenda& agenda_;
    Kernel& kernel_;
    WireWatch* watch_ = nullptr; ///< null if nobody wants to know
    std::uint8_t number_;
    bool step_stays_ = false; ///< at the end of this packet, for one that was withdrawn
    const PacketTimes& times_;
};

} // namespace placedpar::hardware
