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

/// Answers a request that a transputer's program makes to its host, such as to read a file: iserver::Server::answer,
/// for example.
using Answering = std::function<iserver::Answer(iserver::ByteView request, std::chrono::microseconds since_start)>;

/// Acts as the host computer at a link of an emulated transputer. Sends a bootable file over the link, then answers the
/// program's requests until the program exits.
class BootHost final : public transputer::ByteEnd {
public:
    /// `file` holds the bytes that boot the transputer; empty if its program is in its memory when the run begins.
    /// `request_time` is the time for which the host works on each request. REQUIRES: request_time >= 0.
    BootHost(std::vector<std::uint8_t> file, Answering, Time request_time);

    /// Boots the transputer and answers its program's requests. This is the body of the host's process. Returns when
    /// the program has exited, or has sent bytes that are not a request. Waits for ever if the program asks for input
    /// and none is left.
    void serve();

    /// Makes serve() return early. Called when an error has stopped a transputer.
    void abandon();

    /// The functions below return results of serve(), after it has returned.
    iserver::ServerState state() const { return state_; }
    std::int32_t exit_status() const { return exit_status_; }
    /// Returns why the bytes from the program are not a request; "" if all requests could be read.
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
