#include "gaprocs/window.hpp"

#include <algorithm>
#include <utility>

namespace placedpar {

SlidingWindow::SlidingWindow(const WindowSettings& settings)
    : length_(settings.length), first_(std::min(settings.first, settings.length)) {
    settings.validate();
}

void SlidingWindow::push(Sample sample) {
    if (samples_.size() == length_)
        samples_.erase(samples_.begin());
    samples_.push_back(std::move(sample));
}

} // namespace placedpar
