#pragma once

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace placedpar::page {

/// The first and the last of many: all of them while there are at most twice as many as it keeps of each end.
template <class Entry>
class BothEnds {
public:
    explicit BothEnds(std::size_t of_each_end) : most_(of_each_end) {}

    void add(Entry entry) {
        if (first_.size() < most_)
            return first_.push_back(std::move(entry));
        last_.push_back(std::move(entry));
        if (last_.size() > most_) {
            last_.pop_front();
            ++left_out_;
        }
    }
    std::size_t left_out() const { return left_out_; }
    const std::vector<Entry>& first() const { return first_; }
    const std::deque<Entry>& last() const { return last_; }

private:
    std::size_t most_, left_out_ = 0;
    std::vector<Entry> first_;
    std::deque<Entry> last_;
};

} // namespace placedpar::page
