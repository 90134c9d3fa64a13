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

/// Lets another program on this computer act as the host at a link of an emulated transputer, such as INMOS's original
/// iserver. Virtual time waits for this program only while nothing else can happen in the simulation. The times at
/// which the program's bytes arrive therefore differ from run to run.
class OutsideHost final : public transputer::ByteEnd {
public:
    /// The host looks for bytes from the program at intervals of this virtual time.
    static constexpr Time looks_every = std::chrono::microseconds{100};

    /// REQUIRES: a program has connected to the board, which outlives the run.
    explicit OutsideHost(iserver::OfferedBoard& board) : board_(board) {}

    /// Passes bytes between the link and the program, in both directions. This is the body of the host's process.
    /// Returns when the program closes its connection, or when an error has stopped a transputer.
    void serve();
    /// Makes serve() return early. Called when an error has stopped a transputer.
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
    std::size_t read_ = 0; ///< number of bytes of `from_program_` that the transputer has taken
    Alarm alarm_{*this};
    bool gives_ = false, waits_ = false, abandoned_ = false;
};

} // namespace placedpar
