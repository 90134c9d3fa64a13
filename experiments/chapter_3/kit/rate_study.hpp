#pragma once

#include "experiments/chapter_3/kit/fault_study.hpp"
#include "experiments/kit/experiment.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "report/comparison.hpp"

namespace placedpar {

/// The sampling rate of a logger, with its name.
struct LoggerRate {
    const char* name;
    double period_s;
    bool with_faults; ///< if false, only sound machines are tested
};

/// The study has sound machines at 50 Hz, 200 Hz, 1 kHz and 5 kHz, and faulty ones at 50 Hz and 1 kHz.
inline constexpr LoggerRate logger_rates[]{
    {"50 Hz", 0.02, true}, {"200 Hz", 0.005, false}, {"1 kHz", 0.001, true}, {"5 kHz", 0.0002, false}};

/// Returns a movement in which the valve stays open for 12 s. The motion is steady for most of this time, so the
/// movement does not determine a compliance.
PlantFault long_movement(const RecordSource& source);

/// Compares the verdicts on machines (tested_machine.hpp), one for each seed of the replay, whose loggers have these
/// rates. Sound machines make a long movement, then sound_movements usual movements and another long movement. The
/// other machines become faulty as in verdict_comparison().
Comparison rate_comparison(const ReplayContext& context, const char* machine, const RecordSource& source,
                           hydraulics::AreasFrom from);

} // namespace placedpar
