#pragma once

#include "netlist/kinds/environment.hpp"
#include "netlist/kinds/machine_use.hpp"
#include "runtime/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

struct ProcessUse {
    std::string name;
    std::string processor;
    Time waiting;                    ///< how long it waited, with all its components
    std::optional<Time> waits_since; ///< if it waits at the end, for what does not come: since when
};

/// What a run reports: how it ended, what the processes measured, and how its work used the machine.
struct RunReport : MachineUse {
    RunResult result; ///< its fingerprint covers the measurements too
    std::vector<Measurement> measurements;
    std::vector<ProcessUse> processes;
    std::vector<FaultUse> faults;

    /// The part of the run that took so long. None in a deadlock, which lasts for ever.
    std::optional<double> share(Time) const;

    /// The measurement of that name by that process; throws UserError if there is none.
    double measured(std::string_view process, std::string_view name) const;
    const std::string& measured_text(std::string_view process, std::string_view name) const;
};

/// Sorted by the processes' places in the netlist; each one's stay in the order in which it made them.
std::vector<Measurement> in_order_of_netlist(std::vector<Measurement>, const Network&);

/// The fingerprint of a run: of the order of its events, and of what its processes measured.
std::uint64_t fingerprint_with(std::uint64_t events, const std::vector<Measurement>& measurements);

} // namespace placedpar
