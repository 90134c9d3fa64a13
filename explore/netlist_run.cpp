#include "explore/netlist_run.hpp"

#include "explore/problems.hpp"
#include "netlist/machine.hpp"
#include "netlist/repeated_run.hpp"

namespace placedpar {

/// Registers a simulation with an interruption for the lifetime of this object.
class InterruptibleSimulation {
public:
    InterruptibleSimulation(Simulation& simulation, Interruption* interruption) : interruption_(interruption) {
        if (!interruption_)
            return;
        interruption_->simulation_ = &simulation;
        if (interruption_->requested()) // the request came before the simulation was registered
            simulation.interrupt();
    }
    ~InterruptibleSimulation() {
        if (interruption_)
            interruption_->simulation_ = nullptr;
    }
    InterruptibleSimulation(const InterruptibleSimulation&) = delete;
    InterruptibleSimulation& operator=(const InterruptibleSimulation&) = delete;

private:
    Interruption* interruption_;
};

void Interruption::request() noexcept {
    requested_ = true;
    if (Simulation* simulation = simulation_.load())
        simulation->interrupt();
}

RunReport run_netlist(const Network& network, const ProblemRegistry& problems, const RunSettings& settings) {
    return run_netlist(network, known_kinds(problems, settings.observer, settings.checkpoints), settings);
}

RunReport run_netlist(const Network& network, const Catalogue& catalogue, const RunSettings& settings) {
    Machine machine(network, catalogue, settings.seed);
    if (settings.shuffle)
        machine.shuffle(*settings.shuffle);
    if (settings.trace)
        machine.trace_to(*settings.trace);
    if (settings.record)
        machine.record(*settings.record);
    InterruptibleSimulation interruptible(machine.simulation(), settings.interruption);
    return machine.run(settings.until);
}

std::optional<RunReport> repeat_netlist(const Network& network, const Catalogue& catalogue, const RecordedRun& record,
                                        const RunSettings& settings) {
    RepeatedRun run(network, catalogue, settings.seed, record);
    InterruptibleSimulation interruptible(run.simulation(), settings.interruption);
    return run.run();
}

} // namespace placedpar
