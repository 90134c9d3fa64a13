#pragma once

#include "gaprocs/search_problem.hpp"
#include "gaprocs/settings.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace placedpar {

/// The newest samples of measurements, oldest first, over which a search evaluates individuals. A full window has
/// WindowSettings::length samples.
class SlidingWindow {
public:
    /// Makes an empty window. Throws what settings.validate() throws.
    explicit SlidingWindow(const WindowSettings& settings);

    /// Adds the newest sample, and removes the oldest from a full window.
    void push(Sample sample);
    void clear() { samples_.clear(); }

    /// Returns whether there are enough samples for a generation.
    bool ready() const { return samples_.size() >= first_; }
    std::span<const Sample> samples() const { return samples_; }

private:
    std::size_t length_;
    std::size_t first_;
    std::vector<Sample> samples_;
};

} // namespace placedpar
