#include "observe/page/both_ends.hpp"

#include "observe/page/encoding.hpp"

#include <utility>

namespace placedpar::page {

void BothEnds::End::add(PackedStretch stretch) {
    bytes += stretch.bytes.size();
    stretches.push_back(std::move(stretch));
}

PackedStretch BothEnds::End::take_first() {
    PackedStretch first = std::move(stretches.front());
    stretches.pop_front();
    bytes -= first.bytes.size();
    return first;
}

void BothEnds::add(PackedStretch stretch) {
    bool is_first = last_.stretches.empty() && !lost_ && first_.bytes + stretch.bytes.size() <= most_;
    (is_first ? first_ : last_).add(std::move(stretch));
    while (last_.bytes > most_) {
        PackedStretch lost = last_.take_first();
        left_out_ += lost.entries;
        lost_ = {lost_ ? lost_->begin : lost.begin, lost.end};
    }
}

void BothEnds::deflate() {
    for (End* end : {&first_, &last_})
        for (std::size_t n = end->stretches.size(); n > 0; --n) {
            PackedStretch each = end->take_first();
            each.bytes = deflated(each.bytes);
            end->add(std::move(each));
        }
}

std::vector<const PackedStretch*> BothEnds::all() const {
    std::vector<const PackedStretch*> all;
    for (const End* end : {&first_, &last_})
        for (const PackedStretch& each : end->stretches)
            all.push_back(&each);
    return all;
}

} // namespace placedpar::page
