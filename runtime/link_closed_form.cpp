// The closed form of a message on a link whose other direction is quiet. Its bytes follow each other at a
// fixed period, so that those between the first and the last need no events: only the start of the last is
// scheduled. When the other direction wants one of the wires after all, the state that the bytes would have
// left is worked out, and from there on every byte is simulated again.

#include "runtime/kernel.hpp"
#include "runtime/link.hpp"

#include <algorithm>
#include <utility>

namespace placedpar {

/// The acknowledge of the first byte, or of a later one, has started.
void LinkDirection::skip_middle_bytes() {
    skipped_bytes_ = std::exchange(bytes_left_, 1) - 1;
    bytes_carried_ += skipped_bytes_;
    first_skipped_start_ = std::max(may_start_, out_.free_at());
    start_byte_.schedule(first_skipped_start_ + skipped_bytes_ * timing_.byte_period());
}

/// Everything that bytes and acknowledges do up to and including the moment given has happened; what comes
/// after it becomes events.
void LinkDirection::simulate_bytes_again(Time happened_until) {
    if (skipped_bytes_ == 0)
        return;
    cancel(start_byte_);
    std::int64_t started = 0;
    if (happened_until >= first_skipped_start_)
        started =
            std::min<std::int64_t>((happened_until - first_skipped_start_) / timing_.byte_period() + 1, skipped_bytes_);
    std::uint32_t to_come = std::exchange(skipped_bytes_, 0) - static_cast<std::uint32_t>(started);
    bytes_left_ += to_come;
    bytes_carried_ -= to_come;
    if (started > 0) {
        Time start = first_skipped_start_ + (started - 1) * timing_.byte_period();
        out_.occupied_until(start + timing_.data());
        Time noticed = start + timing_.wire_delay + timing_.acknowledge_latency();
        if (noticed > happened_until) {
            byte_noticed_.schedule(noticed);
            return;
        }
        back_.occupied_until(noticed + timing_.acknowledge());
        may_start_ = noticed + timing_.wire_delay + timing_.restart_latency();
    }
    start_byte_.schedule(std::max(may_start_, kernel_.now()));
}

} // namespace placedpar
