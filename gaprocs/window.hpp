#pragma once

#include "gaprocs/search_problem.hpp"
#include "gaprocs/settings.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// The last `length` measured samples, oldest first.
class SlidingWindow {
public:
    /// Throws std::invalid_argument as WindowSettings::validate().
    explicit SlidingWindow(const WindowSettings& settings);

    /// The newest sample comes in; the oldest leaves a full window.
    void push(Sample sample);
    void clear() { samples_.clear(); }

    /// Enough samples for a generation?
    bool ready() const { return samples_.size() >= first_; }
    std::span<const Sample> samples() const { return samples_; }

private:
    std::size_t length_;
    std::size_t first_;
    std::vector<Sample> samples_;
};

} // namespace placedpar
