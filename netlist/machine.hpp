#pragma once

#include "netlist/catalogue.hpp"
#include "netlist/environment.hpp"
#include "netlist/network.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/multiplexer.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/simulation.hpp"

#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <vector>

namespace placedpar {

struct ProcessorUse {
    std::string name;
    std::string type;
    double busy; ///< fraction of the run
};

struct LinkUse {
    std::string from, to; ///< "t[0].link[3]"
    std::uint64_t bytes;
    double occupied; ///< fraction of the run in which its wire carried their bits
};

struct ProcessUse {
    std::string name;
    std::string processor;
    double waiting; ///< fraction of the run
};

/// What a run reports: how it ended, what the processes measured, and how the machine was used.
struct RunReport {
    RunResult result; ///< its fingerprint covers the measurements too
    std::vector<Measurement> measurements;
    std::vector<ProcessorUse> processors;
    std::vector<LinkUse> links;
    std::vector<ProcessUse> processes;

    /// The measurement of that name by that process; throws std::out_of_range if there is none.
    double measured(std::string_view process, std::string_view name) const;
    const std::string& measured_text(std::string_view process, std::string_view name) const;
};

/// A network turned into a simulation: its processors, links and processes, wired as the netlist says.
/// Runs once.
class Machine {
public:
    /// Throws std::invalid_argument if a process's kind is not in the catalogue or stands for a program that
    /// PlacedPar does not have, or if a channel leads to an edge, where nobody is.
    Machine(const Network&, const Catalogue&, std::uint64_t seed);

    RunReport run(Time limit = Time::max());
    void interrupt() { simulation_.interrupt(); }
    /// REQUIRES: before run(); the sink outlives it.
    void trace_to(TraceSink& sink) { simulation_.trace_to(sink); }

private:
    void make_processors();
    void make_links();
    void make_channels(const Catalogue&);
    void carry(AnyChannel&, const NetworkChannel&);
    void make_processes(const Catalogue&);
    std::string link_name(const LinkEnd&) const;
    RunReport report(RunResult) const;

    Network network_;
    std::uint64_t seed_;
    Simulation simulation_;
    std::vector<Processor*> processors_; ///< by node; null for a workstation
    std::vector<Link*> links_;           ///< by connection
    std::vector<Multiplexer*> multiplexers_;
    std::vector<std::unique_ptr<AnyChannel>> channels_;
    std::list<ProcessEnvironment> environments_;
    std::vector<Process*> processes_;
    std::vector<Measurement> measurements_;
};

} // namespace placedpar
