#pragma once

#include "runtime/time.hpp"

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace placedpar::hardware {

/// What goes wrong with a link, and when. A packet is one byte of data or one acknowledge; whether a fault strikes it
/// is decided when it begins on its wire: ours, since a packet of which only a part comes over is understood by luck.
struct LinkFault {
    enum class Kind {
        silent,            ///< packets vanish
        loses_acknowledge, ///< the first acknowledge that begins at `from` or later vanishes
        slow               ///< a bit lasts `factor` times as long, on both wires: the ends of a link run at one speed
    };
    Kind kind = Kind::silent;
    Time from{};
    Time until = Time::max(); ///< from this moment on all is well again; loses_acknowledge does not use it
    bool wire_from_a = true;  ///< it strikes what leaves a: bytes from a to b, acknowledges of bytes from b to a
    bool wire_from_b = true;
    std::int64_t factor = 1; ///< of `slow`
};

/// What a fault has done.
struct FaultEffect {
    /// A packet that it struck: a byte of a message or its acknowledge.
    struct Hit {
        Time at;
        std::string channel; ///< whose message it was
        bool acknowledge;
        std::uint64_t byte; ///< of the message, from 1
        /// Of a link between routers the message is a packet of the channel's, or a packet that acknowledges one.
        enum class Message { whole, packet, acknowledging_packet };
        Message message = Message::whole;
    };
    std::uint64_t bytes_lost = 0, acknowledges_lost = 0;
    std::optional<Hit> first, last;
};

/// Something on the way of a link that does not always lead its packets on, such as a switch that is set during the
/// run. It says by a Link::WayChange when it begins or ceases to lead them on.
class Passage {
public:
    /// Whether it leads what leaves a, or what leaves b, to the other end now.
    virtual bool leads_on(bool leaves_a) const = 0;
    /// The packet, which begins now, gets no further.
    virtual void lose(const FaultEffect::Hit& packet, bool leaves_a) = 0;

protected:
    ~Passage() = default;
};

/// The faults of one link, and what it leads through. They are looked up when a packet begins and need no events, so
/// that a link suffers nothing while nobody uses it.
class LinkFaults {
public:
    explicit LinkFaults(std::int64_t bits_per_second) : bits_per_second_(bits_per_second) {}

    /// Throws std::logic_error unless 0 <= from < until and factor >= 1. The effect is kept up to date.
    const FaultEffect& add(const LinkFault&);
    /// REQUIRES: it outlives the run.
    void lead_through(Passage& passage) { passages_.push_back(&passage); }

    /// At this moment.
    std::int64_t bits_per_second(Time now) const;
    /// Whether the byte or acknowledge that begins now is lost. Notes what the faults have done.
    bool take(const FaultEffect::Hit& packet, bool leaves_a);
    /// All packets that begin from now until that moment get over, at the speed of now, with nothing to note, if what
    /// they lead through does not change.
    Time steady_until(Time now) const;

private:
    struct Each {
        LinkFault fault;
        FaultEffect effect = {};
        bool spent = false; ///< the one acknowledge is lost
        bool acts(Time now) const { return !spent && fault.from <= now && now < fault.until; }
        bool takes(const FaultEffect::Hit&, bool leaves_a) const;
        Time steady_until(Time now) const;
    };

    std::int64_t bits_per_second_; ///< without faults
    std::deque<Each> faults_;      ///< their effects keep their places
    std::vector<Passage*> passages_;
};

} // namespace placedpar::hardware
