#include "workbench/netlist_run.hpp"

#include "workbench/problems.hpp"

namespace placedpar {

/// While it exists, the interruption knows the machine.
class InterruptibleMachine {
public:
    InterruptibleMachine(Machine& machine, Interruption& interruption) : interruption_(interruption) {
        interruption_.machine_ = &machine;
        if (interruption_.requested()) // before it knew the machine
            machine.interrupt();
    }
    ~InterruptibleMachine() { interruption_.machine_ = nullptr; }
    InterruptibleMachine(const InterruptibleMachine&) = delete;
    InterruptibleMachine& operator=(const InterruptibleMachine&) = delete;

private:
    Interruption& interruption_;
};

void Interruption::request() noexcept {
    requested_ = true;
    if (Machine* machine = machine_.load())
        machine->interrupt();
}

RunReport run_netlist(const Network& network, const ProblemRegistry& problems, const RunSettings& settings) {
    return run_netlist(network, known_kinds(problems, settings.observer), settings);
}

RunReport run_netlist(const Network& network, const Catalogue& catalogue, const RunSettings& settings) {
    Machine machine(network, catalogue, settings.seed);
    if (settings.shuffle)
        machine.shuffle(*settings.shuffle);
    if (settings.trace)
        machine.trace_to(*settings.trace);
    Interruption never;
    InterruptibleMachine interruptible(machine, settings.interruption ? *settings.interruption : never);
    return machine.run(settings.until);
}

} // namespace placedpar
