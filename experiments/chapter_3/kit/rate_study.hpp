#pragma once

#include "experiments/chapter_3/kit/fault_study.hpp"
#include "experiments/kit/experiment.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "report/comparison.hpp"

namespace placedpar {

struct LoggerRate {
    const char* name;
    double period_s;
    bool with_faults; ///< whether faulty machines are tested as well as sound machines
};

/// The rates of readings at which the on-line diagnosis is tested. Faulty machines are tested only at 50 Hz and 1 kHz.
inline constexpr LoggerRate logger_rates[]{
    {"50 Hz", 0.02, true}, {"200 Hz", 0.005, false}, {"1 kHz", 0.001, true}, {"5 kHz", 0.0002, false}};

/// Returns parameters that keep the valve open for 12 s. The motion is steady for most of this time. A steady motion
/// does not determine a compliance, so it tests whether the diagnosis then gives false alarms.
PlantFault long_movement(const RecordSource& source);

/// Returns a table of the diagnosis's verdicts at each of `logger_rates`. For each seed of the replay, one machine
/// (tested_machine.hpp) is tested. Sound machines make a long movement, then `sound_movements` usual movements and
/// another long movement. Faulty machines move as in verdict_comparison() (verdict_study.hpp).
Comparison rate_comparison(const ReplayContext& context, const char* machine, const RecordSource& source,
                           hydraulics::AreasFrom from);

} // namespace placedpar
