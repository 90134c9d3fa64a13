#include "gaprocs/window.hpp"

#include <algorithm>
#include <utility>

namespace placedpar {

namespace {

std::size_t samples_before_first_generation(const WindowSettings& settings) {
    return std::min(settings.first, settings.length);
}

} // namespace

SlidingWindow::SlidingWindow(const WindowSettings& settings)
    : length_(settings.length), first_(samples_before_first_generation(settings)) {
    settings.validate();
}

void SlidingWindow::push(Sample sample) {
    if (samples_.size() == length_)
        samples_.erase(samples_.begin());
    samples_.push_back(std::move(sample));
}

std::size_t generations_over(std::size_t record_length, const WindowSettings& settings) {
    settings.validate();
    std::size_t first = samples_before_first_generation(settings);
    return record_length < first ? 0 : (record_length - first + 1) * settings.trials;
}

} // namespace placedpar
