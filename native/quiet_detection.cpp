#include "native/quiet_detection.hpp"

#include <algorithm>

namespace placedpar::native {

QuietDetection::Verdict QuietDetection::take(std::size_t rank, const QuietAnswer& answer) {
    answers_[rank] = answer;
    return --missing_ > 0 ? Verdict::unknown : compare();
}

QuietDetection::Verdict QuietDetection::compare() {
    std::uint64_t sent = 0, received = 0;
    for (const QuietAnswer& each : answers_) {
        sent += each.sent;
        received += each.received;
    }
    const bool is_quiet = received_before_ == sent;
    received_before_ = received;
    if (!is_quiet)
        return Verdict::again;
    received_before_.reset();
    return std::ranges::any_of(answers_, &QuietAnswer::awaits_end) ? Verdict::quiet : Verdict::over;
}

} // namespace placedpar::native
