#pragma once

#include "experiments/chapter_3/kit/fault_study.hpp"
#include "experiments/kit/experiment.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "report/comparison.hpp"

namespace placedpar {

/// How often a logger reads, and what that is called.
struct LoggerRate {
    const char* name;
    double period_s;
    bool with_faults; ///< or sound machines only
};

/// Sound machines at 50 Hz, 200 Hz, 1 kHz and 5 kHz, and faulty ones at 50 Hz and 1 kHz.
inline constexpr LoggerRate logger_rates[]{
    {"50 Hz", 0.02, true}, {"200 Hz", 0.005, false}, {"1 kHz", 0.001, true}, {"5 kHz", 0.0002, false}};

/// A movement in which the valve stays open for twelve seconds, most of them steady: nothing moves that could tell a
/// compliance.
PlantFault long_movement(const RecordSource& source);

/// What is said of machines of their own (tested_machine.hpp), as many as the replay has seeds, whose loggers read at
/// these rates: of sound ones in a long movement, in sound_movements usual ones and in another long one; of those that
/// become faulty as verdict_comparison() does.
Comparison rate_comparison(const ReplayContext& context, const char* machine, const RecordSource& source,
                           hydraulics::AreasFrom from);

} // namespace placedpar
