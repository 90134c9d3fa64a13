#pragma once

#include "runtime/time.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::hardware {

/// A fault of a link, which loses or slows down packets. A packet is one byte of data or one acknowledge. A packet is
/// lost if the fault acts when the packet begins on its wire. This rule is our choice: a receiver could understand half
/// a packet only by chance.
struct LinkFault {
    enum class Kind {
        silent,            ///< packets are lost
        loses_acknowledge, ///< loses the first acknowledge that begins at or after `from`
        slow               ///< a bit lasts `factor` times as long, always on both wires, because both ends of a link
                           ///< run at the same speed
    };
    Kind kind = Kind::silent;
    Time from{};
    Time until = Time::max(); ///< end of the fault; not used by loses_acknowledge
    bool wire_from_a = true;  ///< the fault acts on packets that leave end a: bytes from a to b, and acknowledges of
                              ///< bytes from b to a
    bool wire_from_b = true;  ///< the fault acts on packets that leave end b
    std::int64_t factor = 1;  ///< for `slow`
};

/// What a fault has lost so far.
struct FaultEffect {
    /// A packet that was lost: a byte of a message, or its acknowledge.
    struct Hit {
        Time at;
        std::string channel; ///< name of the channel that the message belonged to
        bool acknowledge;
        std::uint64_t byte; ///< number of the byte in the message, from 1
        /// The kind of message. Routers send the messages of channels in packets. On a link between routers, each
        /// message is such a packet, or acknowledges such a packet.
        enum class Message { whole, packet, acknowledging_packet };
        Message message = Message::whole;
    };
    std::uint64_t bytes_lost = 0, acknowledges_lost = 0;
    std::optional<Hit> first, last;
};

/// A device on the path of a link that may stop packets, such as a switch that is set during the run. While the device
/// begins or ceases to pass on packets, it must hold a Link::WayChange.
class SwitchPath {
public:
    /// Returns whether packets from end a (`leaves_a`) or end b (otherwise) now reach the other end.
    virtual bool leads_on(bool leaves_a) const = 0;
    /// Records that a packet that begins now is lost.
    virtual void lose(const FaultEffect::Hit& packet, bool leaves_a) = 0;

protected:
    ~SwitchPath() = default;
};

/// The faults of one link, and the devices through which it leads. The link asks for their effect when a packet begins,
/// so they need no events.
class LinkFaults {
public:
    explicit LinkFaults(std::int64_t bits_per_second) : bits_per_second_(bits_per_second) {}

    /// Adds a fault. Returns a record of its effects, which is kept up to date. Throws std::logic_error unless 0 <=
    /// from < until and factor >= 1.
    const FaultEffect& add(const LinkFault&);
    /// Adds a device. REQUIRES: the device outlives the run.
    void lead_through(SwitchPath& passage) { passages_.push_back(&passage); }

    /// Returns the speed of the link now.
    std::int64_t bits_per_second(Time now) const;
    /// Returns whether the byte or acknowledge that begins now is lost. Records a loss in the effects.
    bool strike(const FaultEffect::Hit& packet, bool leaves_a);
    /// Returns a time up to which no packet is lost and the speed does not change, unless a device on the path changes
    /// before.
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

    std::int64_t bits_per_second_; ///< speed without faults
    std::deque<Each> faults_;      ///< a deque, because references to the effects must stay valid
    std::vector<SwitchPath*> passages_;
};

} // namespace placedpar::hardware
