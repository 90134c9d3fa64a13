#include "runtime/parallel.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"
#include "runtime/replay_log.hpp"

#include <list>
#include <utility>
#include <vector>

namespace placedpar {

Priority own_priority() { return Kernel::here().running().priority(); }

namespace {

/// Returns the cost of starting all components except the last one, which runs in the place of the process.
Cycles cost_of_starting(const std::vector<Component>& components, Priority own, const OperationCosts& cost) {
    Cycles all{};
    for (std::size_t i = 0; i + 1 < components.size(); ++i)
        all = all + (components[i].priority == own ? cost.start_component : cost.run_component);
    return all;
}

void note_beginning(const std::vector<Component>& components, ReplayLog& history) {
    for (const Component& component : components)
        history.record(ReplayLog::Action::parallel, components.size(),
                       {static_cast<std::uint64_t>(component.priority)});
}

/// Returns a body that first executes `body`, and then takes the cycles that a processor needs to end a component of a
/// PAR.
Process::Body with_end(const Process& parent, Process::Body body) {
    if (!parent.executive())
        return body;
    return [body = std::move(body)] {
        body();
        charge(Kernel::here().running(), &OperationCosts::end_component);
    };
}

/// Returns the component that takes the parent's place on the executive: the last one, or, in a shuffled run, a random
/// one of the parent's priority.
Process& successor_among(std::list<Process>& components, const Process& parent) {
    RandomStream* const lots = parent.kernel().lots();
    std::vector<Process*> equals;
    for (Process& each : components)
        if (lots && each.priority() == parent.priority())
            equals.push_back(&each);
    return equals.empty() ? components.back() : *equals[lots->below(static_cast<std::uint32_t>(equals.size()))];
}

} // namespace

void run_in_parallel(std::vector<Component> components, const SourceLocation& where) {
    if (components.empty())
        return;
    Kernel& kernel = Kernel::here();
    Process& self = kernel.running();
    ReplayLog* history = kernel.begin_operation(self);
    if (history)
        note_beginning(components, *history);
    charge(self, [&](const OperationCosts& cost) { return cost_of_starting(components, self.priority(), cost); });
    Join join{components.size(), self};
    std::list<Process> processes;
    for (std::size_t i = 0; i < components.size(); ++i) {
        processes.emplace_back(self, i, with_end(self, std::move(components[i].body)), components[i].priority, join);
        if (history)
            processes.back().keep(history->component());
    }
    join.first_ordinal = processes.front().ordinal();
    Process& successor = successor_among(processes, self);
    for (Process& process : processes)
        if (&process != &successor || !self.executive())
            kernel.make_ready(process);
    self.wait_for_components(successor, where);
    if (history)
        history->components_have_ended();
}

} // namespace placedpar
