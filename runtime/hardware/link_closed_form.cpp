// The closed form of a message on a link whose other direction is quiet. Its bytes follow each other at a
// fixed period, so that those between the first and the last need no events: only the start of the last is
// scheduled. If the other direction wants one of the wires before that, the state in which simulated bytes would have
// left the link is computed, and from there on every byte is simulated again.

#include "runtime/hardware/link.hpp"
#include "runtime/kernel.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::hardware {

/// REQUIRES: the acknowledge of a byte has just started, and the other direction is quiet.
void LinkDirection::skip_middle_bytes() {
    skipped_bytes_ = std::exchange(bytes_left_, 1) - 1;
    bytes_carried_ += skipped_bytes_;
    first_skipped_start_ = std::max(may_start_, out_.free_at());
    start_byte_.schedule(later(first_skipped_start_, times(skipped_bytes_, timing_.byte_period())));
    if (kernel_.trace())
        trace_bytes(first_skipped_start_);
}

std::uint32_t LinkDirection::skipped_bytes_started() const { return skipped_bytes_started_by(kernel_.now()); }

std::uint32_t LinkDirection::skipped_bytes_started_by(Time when) const {
    if (skipped_bytes_ == 0 || when < first_skipped_start_)
        return 0;
    return static_cast<std::uint32_t>(
        std::min<std::int64_t>((when - first_skipped_start_) / timing_.byte_period() + 1, skipped_bytes_));
}

/// Bytes that started and acknowledges that were requested up to and including this moment count as done; later ones
/// become events. At this very moment that is right because of the order within an instant (EventQueue::Priority):
/// acknowledges have been requested before another direction or process asks for a wire, and starts of bytes on
/// different wires do not affect each other.
void LinkDirection::simulate_bytes_again() {
    if (skipped_bytes_ == 0)
        return;
    Time now = kernel_.now();
    cancel(start_byte_);
    std::uint32_t started = skipped_bytes_started();
    std::uint32_t to_come = std::exchange(skipped_bytes_, 0) - started;
    bytes_left_ += to_come;
    bytes_carried_ -= to_come;
    if (started > 0) {
        Time start = first_skipped_start_ + (started - 1) * timing_.byte_period();
        last_start_ = start;
        out_.occupied_until(later(start, timing_.data()));
        Time noticed = later(start, timing_.wire_delay + timing_.acknowledge_latency());
        if (noticed > now) {
            unacknowledged_ = byte_comes_over_ = true;
            byte_noticed_.schedule(noticed);
            return;
        }
        back_.occupied_until(later(noticed, timing_.acknowledge()));
        may_start_ = later(noticed, timing_.wire_delay + timing_.restart_latency());
    }
    start_byte_.schedule(std::max(may_start_, now));
}

} // namespace placedpar::hardware
