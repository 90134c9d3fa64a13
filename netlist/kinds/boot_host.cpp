#include "netlist/kinds/boot_host.hpp"

#include "runtime/kernel.hpp"
#include "runtime/timer.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace placedpar {

BootHost::BootHost(std::vector<std::uint8_t> file, Answering answering, Time request_time)
    : file_(std::move(file)), answering_(std::move(answering)), request_time_(request_time) {}

void BootHost::serve() {
    process_ = &Kernel::here().running();
    if (!file_.empty())
        send(file_);
    booted_ = !abandoned_;
    booted_at_ = Kernel::here().now();
    while (state_ == iserver::ServerState::running && !abandoned_) {
        const iserver::ByteView request = receive();
        if (request.empty())
            return;
        answer(request);
    }
    if (state_ == iserver::ServerState::waits_for_input && !abandoned_)
        wait_for_link(Activity::inputting); // the input has ended, so no reply follows: the host waits for ever
}

/// Answers a request. The request that ends the program gets a reply, too. The host does not wait until the program has
/// taken this reply, since many programs never take it.
void BootHost::answer(iserver::ByteView request) {
    ++requests_;
    if (request_time_ > Time{0})
        wait_for(request_time_);
    const auto now = std::chrono::floor<std::chrono::microseconds>(Kernel::here().now());
    iserver::Answer answer = answering_(request, now);
    state_ = answer.state;
    exit_status_ = answer.exit;
    if (answer.reply.empty())
        return;
    reply_ = std::move(answer.reply);
    give(reply_);
    if (state_ == iserver::ServerState::running)
        wait_for_link(Activity::outputting);
}

void BootHost::give(std::span<const std::uint8_t> bytes) {
    to_send_ = bytes;
    out->give(static_cast<std::uint32_t>(bytes.size()));
}

void BootHost::send(std::span<const std::uint8_t> bytes) {
    give(bytes);
    wait_for_link(Activity::outputting);
}

/// Returns the next request; an empty request if the bytes from the program are not a request.
iserver::ByteView BootHost::receive() {
    iserver::ByteView request;
    while (request.empty() && reader_.wanted() > 0 && !abandoned_) {
        received_.clear();
        in->take(static_cast<std::uint32_t>(reader_.wanted()));
        wait_for_link(Activity::inputting);
        iserver::ByteView bytes = received_;
        request = reader_.take(bytes);
    }
    return request;
}

void BootHost::wait_for_link(Activity why) {
    waits_ = true;
    process_->wait_for(why, nullptr, {});
    waits_ = false;
}

void BootHost::go_on() {
    if (waits_)
        process_->kernel().make_ready(*process_);
    waits_ = false;
}

void BootHost::abandon() {
    abandoned_ = true;
    go_on();
}

void BootHost::read(std::span<std::uint8_t> to) {
    std::ranges::copy(to_send_.first(to.size()), to.begin());
    to_send_ = to_send_.subspan(to.size());
}

void BootHost::write(std::span<const std::uint8_t> bytes) {
    received_.insert(received_.end(), bytes.begin(), bytes.end());
}

} // namespace placedpar
