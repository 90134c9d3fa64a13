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

/// Movements of a sound machine among which an alarm is a false one, and those within which a fault is to be found.
inline constexpr std::size_t sound_movements = 20, faulty_movements = 8;

/// What is wrong with a machine, and what it is to be called.
struct TestedFault {
    PlantFault fault;
    double compliance_factor;         ///< times the machine's own
    identification::AlarmKind called; ///< of the boom
    bool from_first_day = false;      ///< or after three sound movements
    double units = 1;                 ///< of WayUnits
    /// %: of the machines, unless theory's limit is below it, and of those found.
    double least_found = 90, least_called = 95;
    /// %: of those found; none where the records do not allow more.
    std::optional<double> most_undecided = 10;
};

/// The leaks are there at all times, or begin when the valve opens, as those of leak_of(). 10.5 mV move the spool by
/// .005 in. Machines whose valves are known by their areas have no offset. A leak that begins and an offset need not be
/// told apart where no rest follows a movement.
std::vector<TestedFault> tested_faults(const RecordSource& source, hydraulics::AreasFrom from);

/// What is said in the course of some movements.
struct Outcome {
    std::size_t found_after = 0; ///< movements; 0: nothing was found
    bool called = false;         ///< by its name, when it was found
    bool undecided = false;      ///< "leak or offset", of one of the two
};

/// Lets a sound machine make movements until its state of health is known: three that tell it, of as many as it takes.
/// Returns their number. Throws std::runtime_error where fifty do not do it.
std::uint64_t make_known(TestedMachine& machine);

/// Lets the machine make movements with this fault until there is an alarm, `first_number` the one before the first.
Outcome watch(TestedMachine machine, const TestedFault& fault, std::size_t movements, std::uint64_t first_number);

/// What the on-line diagnosis says of machines of their own (tested_machine.hpp), as many as the replay has seeds, at
/// each of the three levels of noise: sound ones, and ones that become faulty after three sound movements or are so
/// from the first. `from`: what it is told of the valve.
Comparison verdict_comparison(const ReplayContext& context, const char* machine, const RecordSource& source,
                              hydraulics::AreasFrom from);

} // namespace placedpar
