#pragma once

#include "runtime/time.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::hardware {

/// What goes wrong with a link, and when. A packet is one byte of data or one acknowledge. Whether a fault strikes it
/// is decided when it begins on its wire. This is our rule, since a half packet would be understood by chance only.
struct LinkFault {
    enum class Kind {
        silent,            ///< packets vanish
        loses_acknowledge, ///< the first acknowledge that begins at `from` or later vanishes
        slow               ///< a bit lasts `factor` times as long, on both wires: the ends of a link run at one speed
    };
    Kind kind = Kind::silent;
    Time from{};
    Time until = Time::max(); ///< the end of the fault; loses_acknowledge does not use it
    bool wire_from_a = true;  ///< strikes what leaves a: bytes from a to b, acknowledges of bytes from b to a
    bool wire_from_b = true;  ///< strikes what leaves b
    std::int64_t factor = 1;  ///< for `slow`
};

/// What a fault has done so far.
struct FaultEffect {
    /// A packet that it struck: a byte of a message or its acknowledge.
    struct Hit {
        Time at;
        std::string channel; ///< the channel whose message it belonged to
        bool acknowledge;
        std::uint64_t byte; ///< its number in the message, from 1
        /// On a link between routers the message is a packet of a channel, or a packet that acknowledges one.
        enum class Message { whole, packet, acknowledging_packet };
        Message message = Message::whole;
    };
    std::uint64_t bytes_lost = 0, acknowledges_lost = 0;
    std::optional<Hit> first, last;
};

/// A device through which a link leads and which may stop its packets, such as a switch that is set during the run. It
/// must hold a Link::WayChange when it begins or ceases to lead packets on.
class SwitchPath {
public:
    /// Whether packets that leave a, or b, now reach the other end.
    virtual bool leads_on(bool leaves_a) const = 0;
    /// Notes that a packet, which begins now, gets no further.
    virtual void lose(const FaultEffect::Hit& packet, bool leaves_a) = 0;

protected:
    ~SwitchPath() = default;
};

/// The faults of one link, and the passages that it leads through. They are consulted when a packet begins and need no
/// events, so that a fault has no effect on a link that carries nothing.
class LinkFaults {
public:
    explicit LinkFaults(std::int64_t bits_per_second) : bits_per_second_(bits_per_second) {}

    /// Adds a fault, and returns a record of its effects, which is kept up to date. Throws std::logic_error unless
    /// 0 <= from < until and factor >= 1.
    const FaultEffect& add(const LinkFault&);
    /// Adds a passage. REQUIRES: it outlives the run.
    void lead_through(SwitchPath& passage) { passages_.push_back(&passage); }

    /// Returns the speed of the link now.
    std::int64_t bits_per_second(Time now) const;
    /// Returns whether the byte or acknowledge that begins now is lost, and records the effects of the faults.
    bool strike(const FaultEffect::Hit& packet, bool leaves_a);
    /// Returns a time before which all packets that begin reach the other end at the present speed, with no effect to
    /// record, unless a passage changes.
    Time steady_until(Time now) const;

private:
    struct Each {
        LinkFault fault;
        FaultEffect effect = {};
        bool spent = false; ///< loses_acknowledge has lost its one acknowledge
        bool acts(Time now) const { return !spent && fault.from <= now && now < fault.until; }
        bool strikes(const FaultEffect::Hit&, bool leaves_a) const;
        Time steady_until(Time now) const;
    };

    std::int64_t bits_per_second_; ///< without faults
    std::deque<Each> faults_;      ///< a deque, since references to the effects must stay valid
    std::vector<SwitchPath*> passages_;
};

} // namespace placedpar::hardware
