#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"
#include "netlist/run_report.hpp"
#include "netlist/software.hpp"
#include "runtime/replay_log.hpp"
#include "runtime/simulation.hpp"

#include <cstdint>
#include <list>
#include <optional>
#include <vector>

namespace placedpar {

/// Holds a run of a network on the simulated machine, and the history of each process: its actions and what it
/// observed. Machine::record() fills the record. A RepeatedRun uses it to get the results of other seeds faster.
struct RecordedRun {
    std::optional<RunReport> report; ///< empty if the network was refused
    std::uint64_t events = 0;        ///< fingerprint of the events
    ReplaySession course;
    std::list<ReplayLog> histories; ///< one for each process of the network

    /// Returns whether the run completed, and all actions of its processes can be repeated.
    bool can_be_repeated() const;
};

/// Returns whether runs of the network can be repeated from histories. All processes must be determinate: their actions
/// depend only on what a history records (ProcessKind::is_determinate). No channel may be broadcast on a bus, since the
/// bus compares the messages of a broadcast. No channel may lead to a transputer that executes machine code. The
/// netlist must not state faults, since processes may see faults as exceptions.
bool is_determinate(const Network&, const Catalogue&);

/// Runs the processes of a recorded run with another seed, without simulating the machine. The processes compute with
/// the random numbers of the new seed. All times are taken from the recorded run. The run cannot be repeated if a
/// process acts differently with the new seed, for example if it computes longer. REQUIRES: is_determinate(network);
/// the recorded run is a run of this network. The network, the catalogue and the recorded run outlive this object.
class RepeatedRun {
public:
    RepeatedRun(const Network&, const Catalogue&, std::uint64_t seed, const RecordedRun&);

    /// Returns the report that a run on the machine with this seed would give, identical to the last bit. If the user
    /// interrupts the repeated run, only `result` is set. Returns nothing if a process acts differently than in its
    /// history, or if the run does not complete.
    std::optional<RunReport> run();
    Simulation& simulation() { return simulation_; }

private:
    std::vector<Measurement> in_recorded_order(const std::vector<Measurement>&) const;

    const Network& network_;
    const RecordedRun& recorded_;
    ReplaySession course_;
    std::list<ReplayLog> histories_;
    Software software_;
    Simulation simulation_;
};

} // namespace placedpar
