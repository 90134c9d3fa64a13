#pragma once

#include "iserver/packet.hpp"
#include "iserver/server.hpp"
#include "runtime/process.hpp"
#include "runtime/source_location.hpp"
#include "runtime/transputer/byte_lane.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace placedpar {

/// Answers a request that is made at a simulated time, as iserver::Server::answer does.
using Answering = std::function<iserver::Answer(iserver::ByteView request, std::chrono::microseconds since_start)>;

/// Acts as the host at the link of an emulated transputer: sends a bootable file down the link, then serves the
/// program's requests until the program exits.
class BootHost final : public transputer::ByteEnd {
public:
    /// `file`: empty if the transputer already has its program when the run begins. `request_time`: how long the host
    /// works on a request. REQUIRES: request_time >= 0.
    BootHost(std::vector<std::uint8_t> file, Answering, Time request_time);

    /// Boots and serves; the body of the host's process. Returns when the program has exited, or when it sends a packet
    /// that cannot be read. Waits for ever when the program asks for input and none is left.
    void serve();

    /// Ends serve(): a transputer has stopped.
    void abandon();

    /// The functions below return results of serve().
    iserver::ServerState state() const { return state_; }
    std::int32_t exit_status() const { return exit_status_; }
    /// Returns why a packet could not be read; "" if all packets could be read.
    const std::string& refusal() const { return reader_.refusal(); }
    std::uint64_t requests() const { return requests_; }
    /// Returns how many bytes of the file the transputer has not taken.
    std::size_t bytes_not_taken() const { return booted_ ? 0 : file_.size(); }
    /// Returns when the last byte of the file was taken.
    Time booted_at() const { return booted_at_; }

private:
    void read(std::span<std::uint8_t>) override;
    void given() override { go_on(); }
    void write(std::span<const std::uint8_t>) override;
    void taken() override { go_on(); }
    void byte_waits() override {}

    void wait_for_link(Activity);
    void go_on();
    void give(std::span<const std::uint8_t>);
    void send(std::span<const std::uint8_t>);
    iserver::ByteView receive();

    void answer(iserver::ByteView request);

    std::vector<std::uint8_t> file_;
    Answering answering_;
    Time request_time_;
    Process* process_ = nullptr;
    iserver::Bytes reply_;
    std::span<const std::uint8_t> to_send_; ///< bytes of the file or the reply that are still to be sent
    std::vector<std::uint8_t> received_;
    iserver::PacketReader reader_;
    iserver::ServerState state_ = iserver::ServerState::running;
    std::int32_t exit_status_ = 0;
    std::uint64_t requests_ = 0;
    Time booted_at_{};
    bool booted_ = false, abandoned_ = false, waits_ = false;
};

} // namespace placedpar
