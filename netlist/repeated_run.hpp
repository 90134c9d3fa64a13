#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"
#include "netlist/run_report.hpp"
#include "netlist/software.hpp"
#include "runtime/history.hpp"
#include "runtime/simulation.hpp"

#include <cstdint>
#include <list>
#include <optional>
#include <vector>

namespace placedpar {

/// A run of a network on its machine, and what its processes did in it (Machine::record).
struct RecordedRun {
    std::optional<RunReport> report; ///< none where it has not ended, but was refused
    std::uint64_t events = 0;        ///< their fingerprint
    RunHistory course;
    std::list<History> histories; ///< by process of the network

    /// It has completed, and its processes did only what can be repeated.
    bool can_be_repeated() const;
};

/// Whether what happens in the network follows from what histories note: of all processes
/// (ProcessKind::is_determinate); none outputs to several on a bus at once, which looks whether these messages are one;
/// and the machine has no faults, of which programs may be told by exceptions.
bool is_determinate(const Network&, const Catalogue&);

/// A run with another seed that takes the same course as one on the machine: its processes compute, with their own
/// numbers, on no machine, and the times, which do not depend on them, are those of the recorded run. Where a process
/// does anything else than it did then, such as computing longer, there is no such run.
///
/// REQUIRES: the network is that of the recorded run, and determinate. All three outlive it.
class RepeatedRun {
public:
    RepeatedRun(const Network&, const Catalogue&, std::uint64_t seed, const RecordedRun&);

    /// The report of the run on the machine, to the last bit; of an interrupted one only that it is. None where the
    /// course would be another, or the run would not complete.
    std::optional<RunReport> run();
    Simulation& simulation() { return simulation_; }

private:
    std::vector<Measurement> in_recorded_order(const std::vector<Measurement>&) const;

    const Network& network_;
    const RecordedRun& recorded_;
    RunHistory course_;
    std::list<History> histories_;
    Software software_;
    Simulation simulation_;
};

} // namespace placedpar
