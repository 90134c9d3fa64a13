#pragma once

#include "netlist/kinds/device_kind.hpp"
#include "runtime/carrier.hpp"
#include "runtime/event.hpp"
#include "runtime/time.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

class Kernel;
class Process;

/// A token ring, as in IEEE 802.5 without its priorities. One token travels from station to station. A station that
/// holds it may put one frame on the ring, and then passes the token on.
class TokenRing {
public:
    static constexpr std::int64_t most_bytes = 4096, header_bytes = 21;
    struct Station {
        std::string name;
        std::uint64_t frames = 0, bytes = 0; ///< numbers of frames and bytes sent
        Time waited{};                       ///< wait for the token
    };

    /// The token leaves the last station when the run begins.
    TokenRing(Kernel&, std::string name, std::int64_t bits_per_second, Time hop,
              const std::vector<std::string>& stations);

    /// The running process sends a frame for the channel. REQUIRES: bytes <= most_bytes.
    void send(std::size_t station, std::int64_t bytes, const AnyChannel&, const SourceLocation&);
    /// From this time on no station gets the token.
    void break_at(Time time) { breaks_at_ = time; }

    const std::vector<Station>& stations() const { return stations_; }
    Time time_busy() const { return busy_; }
    /// Returns the channels of the messages that wait for the token.
    std::vector<std::string> waiting_channels() const;

private:
    struct Frame {
        Process* process;
        const AnyChannel* channel;
        std::size_t station;
        std::int64_t bytes;
        Time asked;
    };
    template <void (TokenRing::*Step)()>
    struct StepEvent final : Event {
        explicit StepEvent(TokenRing& r) : ring(r) {}
        void happen() noexcept override { (ring.*Step)(); }
        TokenRing& ring;
    };
    Time arrival_at(std::size_t station) const;
    void pass_token();
    void begin_frame();
    void end_frame();
    std::string track_of(std::size_t station) const { return name_ + " <- " + stations_[station].name; }

    Kernel& kernel_;
    std::string name_;
    std::int64_t bits_per_second_;
    Time hop_;
    std::vector<Station> stations_;
    std::deque<Frame> waiting_; ///< the first is on the ring while end_frame_ is scheduled
    std::size_t left_;          ///< the station that the token left last
    Time left_at_{}, began_{}, busy_{};
    std::optional<Time> breaks_at_;
    StepEvent<&TokenRing::begin_frame> begin_frame_{*this};
    StepEvent<&TokenRing::end_frame> end_frame_{*this};
};

/// One direction between two stations, one message at a time.
class RingLane final : public Carrier {
public:
    RingLane(Kernel& kernel, TokenRing& ring, std::size_t from) : kernel_(kernel), ring_(ring), from_(from) {}

    void output(AnyChannel&, const WireForm&, const SourceLocation&) override;
    void input(AnyChannel&, const SourceLocation&) override;
    bool message_waits(const AnyChannel&) const override { return full_; }

private:
    void wait_until(bool full, const AnyChannel&, const SourceLocation&);
    void turn(bool full);

    Kernel& kernel_;
    TokenRing& ring_;
    std::size_t from_;
    bool full_ = false; ///< a message has arrived and has not been taken
    Process* waiting_ = nullptr;
};

/// Returns the device kind for netlists: `RING r; connect sun.bus[0] to r.slot[1];`
DeviceKind token_ring();

} // namespace placedpar
