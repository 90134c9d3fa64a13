#pragma once

#include "netlist/kinds/environment.hpp"
#include "netlist/kinds/machine_use.hpp"
#include "netlist/run_outcome.hpp"
#include "runtime/simulation.hpp"

#include <chrono>
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
    Time waiting;                    ///< time in which the process and all its components waited
    std::optional<Time> waits_since; ///< start of the wait that lasts when the run ends; empty if the process does not
                                     ///< wait, or waits only for the end of the run
};

/// Counts the messages from one thread or MPI rank of a native run to another. A native run executes the processes on
/// threads of this computer or on ranks, and simulates no machine.
struct MessagesBetween {
    std::string from, to; ///< "thread 0", "thread 1"
    std::uint64_t messages;
    std::uint64_t bytes; ///< number of bytes that a simulated link would carry for these messages
};

/// Holds the difference between the clocks of an MPI rank and of rank 0. The clocks are compared twice: before and
/// after a native run whose trace is recorded.
struct RankClock {
    std::string name;               ///< "rank 1"
    std::chrono::nanoseconds ahead; ///< the rank's clock minus rank 0's clock, before the run
    Time error;                     ///< greatest possible error of each of the two comparisons
    Time drift;                     ///< increase of `ahead` from before the run to after the run
};

/// Reports a run: how the run ended, what its processes measured, and how much of the machine they used.
struct RunReport : MachineUse {
    bool is_native = false; ///< the processes ran natively: times are those of the wall clock, processors are threads,
                            ///< and the run has no fingerprint
    RunResult result;       ///< its fingerprint covers the measurements, too
    std::vector<Measurement> measurements;
    std::vector<ProcessUse> processes;
    std::vector<MessagesBetween> messages; ///< for a native run; pairs of threads without messages are left out
    std::vector<FaultUse> faults;
    std::vector<RankClock>
        clocks; ///< for a recorded run on several ranks; all times in the report are those of rank 0's clock

    /// Returns how the run ended. Of several answers the first in this order is returned: interrupted, halted,
    /// deadlock, failed, time limit, completed.
    RunOutcome outcome() const;

    /// Returns the time as a fraction of the run's length. Returns nothing after a deadlock, which lasts for ever.
    std::optional<double> share(Time) const;

    /// Return the measurement that a process reported by this name, as a number or as a text. Throw UserError if the
    /// process did not report it.
    double measured(std::string_view process, std::string_view name) const;
    const std::string& measured_text(std::string_view process, std::string_view name) const;
};

/// Returns the measurements sorted by the position of their processes in the netlist. Measurements of one process keep
/// their order.
std::vector<Measurement> in_order_of_netlist(std::vector<Measurement>, const Network&);

/// Returns the fingerprint of a run: a hash of its events and of its measurements. `events` is the hash of the order
/// and times of the events.
std::uint64_t fingerprint_with(std::uint64_t events, const std::vector<Measurement>& measurements);

} // namespace placedpar
