#pragma once

#include "experiments/chapter_3/kit/fault_study.hpp"
#include "experiments/chapter_3/kit/tested_machine.hpp"
#include "experiments/kit/experiment.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "identification/on_line/alarm.hpp"
#include "report/comparison.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace placedpar {

/// The number of movements in a test of the on-line diagnosis. In the movements of a sound machine any alarm is false;
/// in the movements of a faulty machine the fault must be found.
inline constexpr std::size_t sound_movements = 20, faulty_movements = 8;

/// A fault of a machine, and the alarm that it should raise.
struct TestedFault {
    PlantFault fault;
    double compliance_factor;         ///< multiplies the machine's own compliance
    identification::AlarmKind called; ///< the correct alarm for this fault of the boom
    /// True: the fault is there from the first movement; false: it begins after make_known().
    bool from_first_day = false;
    double units = 1; ///< size of the fault in `WayUnits`
    /// Required percentages. `least_found` is the least share of machines whose fault must be found. This bound does
    /// not apply if the 95 % interval of the theoretical limit reaches below the bound. `least_called` is the least
    /// share of the found faults that must be named correctly or left undecided. A share misses its bound only if its
    /// whole 95 % interval is below the bound.
    double least_found = 90, least_called = 95;
    /// The allowed percentage of undecided faults among the found faults; nullopt: no limit.
    std::optional<double> most_undecided = 10;
};

/// Returns the faults to test. A leak is present at all times, or begins when the valve opens (leak_of()). A drift of
/// 10.5 mV moves the spool by .005 in. If the areas are measured, no offset is tested. If the machine is not at rest
/// after a movement, the diagnosis cannot tell an offset from a leak that begins with the movement. Both may then be
/// left undecided.
std::vector<TestedFault> tested_faults(const RecordSource& source, hydraulics::AreasFrom from);

/// The verdicts during some movements.
struct Outcome {
    std::size_t found_after = 0; ///< number of movements until the first alarm; 0: no alarm
    bool called = false;         ///< whether the first alarm names the fault correctly
    bool undecided = false;      ///< whether the first alarm is "leak or offset" and the fault is not a compliance
};

/// Lets a sound machine move until the diagnosis has a baseline for the boom: the compliance of the sound machine, from
/// three informative movements. Returns the number of movements made. Throws std::runtime_error if fifty movements are
/// not enough.
std::uint64_t make_known(TestedMachine& machine);

/// Lets the machine move with this fault until there is an alarm. The first movement has the number `first_number` + 1.
Outcome watch(TestedMachine machine, const TestedFault& fault, std::size_t movements, std::uint64_t first_number);

/// Returns a table of the verdicts of the on-line diagnosis at each of three noise levels. For each seed of the replay,
/// one machine (tested_machine.hpp) is tested: without a fault, and with each fault, which begins after make_known() or
/// with the first movement. `from` says which readings of the valve the diagnosis receives.
Comparison verdict_comparison(const ReplayContext& context, const char* machine, const RecordSource& source,
                              hydraulics::AreasFrom from);

} // namespace placedpar
