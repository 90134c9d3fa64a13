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
    Time waiting; ///< time in which the process and all its components waited
    std::optional<Time>
        waits_since; ///< start of the last wait, if the process still waits at the end and never continues
};

/// Counts the messages that one thread or rank of a native run has sent to another thread or rank.
struct MessagesBetween {
    std::string from, to; ///< "thread 0", "thread 1"
    std::uint64_t messages;
    std::uint64_t bytes; ///< the bytes that a link would carry for these messages
};

/// Holds the result of comparing the clock of a rank with the clock of rank 0, before and after a recorded native run.
struct RankClock {
    std::string name;               ///< "rank 1"
    std::chrono::nanoseconds ahead; ///< how far this clock was ahead of rank 0's clock before the run
    Time error;                     ///< greatest possible error of each of the two comparisons
    Time drift;                     ///< increase of `ahead` from before the run to after the run
};

/// Reports a run: how it ended, what the processes measured, and how its work used the machine.
struct RunReport : MachineUse {
    bool is_native = false; ///< the processes ran natively: the times are read from the wall clock, there is no
                            ///< fingerprint, and the processors are threads
    RunResult result;       ///< the fingerprint in `result` covers the measurements, too
    std::vector<Measurement> measurements;
    std::vector<ProcessUse> processes;
    std::vector<MessagesBetween> messages; ///< messages of a native run; pairs of threads without messages are left out
    std::vector<FaultUse> faults;
    std::vector<RankClock> clocks; ///< clocks of a recorded run on several ranks; the times of the report are read from
                                   ///< the clock of rank 0

    /// Returns how the run ended. An interruption counts first; then an error that has halted a processor, even if
    /// other processes then waited for ever; then a deadlock; then a program that failed.
    RunOutcome outcome() const;

    /// Returns this time as a fraction of the run's length. Returns nothing if the run ended in a deadlock, since a
    /// deadlock lasts for ever.
    std::optional<double> share(Time) const;

    /// Returns the measurement of this name by this process. Throws UserError if there is none.
    double measured(std::string_view process, std::string_view name) const;
    const std::string& measured_text(std::string_view process, std::string_view name) const;
};

/// Returns the measurements sorted by the position of their processes in the netlist. The measurements of a process
/// keep their order.
std::vector<Measurement> in_order_of_netlist(std::vector<Measurement>, const Network&);

/// Returns the fingerprint of a run, which covers the order of its events and the measurements of its processes.
std::uint64_t fingerprint_with(std::uint64_t events, const std::vector<Measurement>& measurements);

} // namespace placedpar
