#include "netlist/kinds/outside_host.hpp"

#include "iserver/offered_board.hpp"
#include "runtime/kernel.hpp"
#include "runtime/source_location.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace placedpar {

void OutsideHost::serve() {
    process_ = &Kernel::here().running();
    taken();
    while (!abandoned_ && pass_bytes_on())
        wait();
    board_.write(from_machine_);
}

/// Passes on the bytes that have arrived, in both directions. Returns false if the program has closed its connection,
/// or if nothing can happen any more.
bool OutsideHost::pass_bytes_on() {
    if (!board_.write(std::exchange(from_machine_, {})))
        return false;
    const bool only_program_can_act = Kernel::here().future().empty();
    std::optional<iserver::Bytes> bytes = board_.read(only_program_can_act);
    if (!bytes || (gives_ && only_program_can_act)) // the machine will never take the bytes that were sent
        return false;
    from_program_.insert(from_program_.end(), bytes->begin(), bytes->end());
    if (gives_ || from_program_.empty())
        return true;
    gives_ = true;
    read_ = 0;
    out->give(static_cast<std::uint32_t>(from_program_.size()));
    return true;
}

void OutsideHost::wait() {
    EventQueue& future = Kernel::here().future();
    future.schedule(alarm_, later(Kernel::here().now(), looks_every), EventQueue::timer);
    waits_ = true;
    process_->wait_for(Activity::inputting, nullptr, {});
    waits_ = false;
    future.cancel(alarm_);
}

void OutsideHost::go_on() {
    if (std::exchange(waits_, false))
        process_->kernel().make_ready(*process_);
}

void OutsideHost::abandon() {
    abandoned_ = true;
    go_on();
}

void OutsideHost::read(std::span<std::uint8_t> to) {
    std::ranges::copy(std::span(from_program_).subspan(read_, to.size()), to.begin());
    read_ += to.size();
}

void OutsideHost::given() {
    gives_ = false;
    from_program_.erase(from_program_.begin(), from_program_.begin() + static_cast<std::ptrdiff_t>(read_));
    go_on();
}

void OutsideHost::write(std::span<const std::uint8_t> bytes) {
    from_machine_.insert(from_machine_.end(), bytes.begin(), bytes.end());
    go_on();
}

/// Requests an endless input from the transputer: each output of the transputer becomes a part of this input.
void OutsideHost::taken() { in->take(std::numeric_limits<std::uint32_t>::max()); }

} // namespace placedpar
