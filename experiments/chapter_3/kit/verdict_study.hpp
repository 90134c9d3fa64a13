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

/// The number of movements of a sound machine in which every alarm is false, and the number within which a fault must
/// be found.
inline constexpr std::size_t sound_movements = 20, faulty_movements = 8;

/// A fault of a machine, and the alarm that it should raise.
struct TestedFault {
    PlantFault fault;
    double compliance_factor;         ///< relative to the machine's own compliance
    identification::AlarmKind called; ///< the right alarm for the boom
    bool from_first_day = false;      ///< if false, the fault begins after three sound movements
    double units = 1;                 ///< size in WayUnits
    /// Required percentages of machines. least_found is the share whose fault is found; it is not required if the 95 %
    /// interval of the theoretical limit goes below it. least_called is the share of the found faults with the right
    /// name. A share misses its bound only if its whole 95 % interval does.
    double least_found = 90, least_called = 95;
    /// The allowed percentage of found faults that are left undecided; nullopt if the records do not allow a limit.
    std::optional<double> most_undecided = 10;
};

/// Returns the faults to test. Leaks are present at all times, or begin when the valve opens, as the leaks of leak_of()
/// do. A drift of 10.5 mV moves the spool by .005 in. Machines whose areas are measured have no offset. A leak that
/// begins and an offset need not be distinguished where no rest follows a movement.
std::vector<TestedFault> tested_faults(const RecordSource& source, hydraulics::AreasFrom from);

/// The verdicts during some movements.
struct Outcome {
    std::size_t found_after = 0; ///< number of movements; 0: nothing was found
    bool called = false;         ///< whether the fault was named correctly when found
    bool undecided = false;      ///< whether the fault was a leak or an offset, and the verdict "leak or offset"
};

/// Lets a sound machine move until its state of health is known, which takes three informative movements. Returns the
/// number of movements. Throws std::runtime_error if fifty are not enough.
std::uint64_t make_known(TestedMachine& machine);

/// Lets the machine move with this fault until there is an alarm. The first movement has the number after
/// `first_number`.
Outcome watch(TestedMachine machine, const TestedFault& fault, std::size_t movements, std::uint64_t first_number);

/// Compares the verdicts of the on-line diagnosis on machines (tested_machine.hpp), one for each seed of the replay, at
/// each of the three noise levels. There are sound machines, machines that become faulty after three sound movements,
/// and machines that are faulty from the first movement. `from` says which readings of the valve the diagnosis gets.
Comparison verdict_comparison(const ReplayContext& context, const char* machine, const RecordSource& source,
                              hydraulics::AreasFrom from);

} // namespace placedpar
