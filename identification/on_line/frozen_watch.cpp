#include "identification/on_line/frozen_watch.hpp"

#include <cmath>

namespace placedpar::identification {

bool FrozenWatch::take(double reading, double least_jump, std::size_t fewest) {
    const double step = state_.last ? std::abs(reading - *state_.last) : 0;
    const bool frozen = state_.jump > step;
    const bool jumps = state_.equal >= fewest && step >= least_jump;
    state_.jump = jumps ? step : 0;
    state_.equal = state_.last == reading ? state_.equal + 1 : 1;
    state_.last = reading;
    return frozen;
}

} // namespace placedpar::identification
