#pragma once

#include "iserver/packet.hpp"
#include "runtime/event.hpp"
#include "runtime/process.hpp"
#include "runtime/transputer/byte_lane.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace placedpar {
namespace iserver {
class OfferedBoard; // iserver/offered_board.hpp
} // namespace iserver

/// Lets a program outside the simulation act as the host at a link of an emulated transputer. Virtual time does not
/// wait for this program, except while nothing else can happen. The times of the program's bytes therefore differ from
/// run to run.
class OutsideHost final : public transputer::ByteEnd {
public:
    /// The simulated time between two checks for bytes from the program.
    static constexpr Time looks_every = std::chrono::microseconds{100};

    /// REQUIRES: a program has connected to the board, which outlives the run.
    explicit OutsideHost(iserver::OfferedBoard& board) : board_(board) {}

    /// Passes bytes in both directions; the body of the host's process. Returns when the program closes the link, or
    /// when the transputer has stopped.
    void serve();
    /// Ends serve(): a transputer has stopped.
    void abandon();

private:
    struct Alarm final : Event {
        explicit Alarm(OutsideHost& h) : host(h) {}
        void happen() noexcept override { host.go_on(); }
        OutsideHost& host;
    };

    void read(std::span<std::uint8_t>) override;
    void given() override;
    void write(std::span<const std::uint8_t>) override;
    void taken() override;
    void byte_waits() override {}

    bool pass_bytes_on();
    void wait();
    void go_on();

    iserver::OfferedBoard& board_;
    Process* process_ = nullptr;
    iserver::Bytes from_program_, from_machine_;
    std::size_t read_ = 0; ///< bytes of `from_program_` that the machine has taken
    Alarm alarm_{*this};
    bool gives_ = false, waits_ = false, abandoned_ = false;
};

} // namespace placedpar
