#include "runtime/parallel.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"

#include <list>
#include <utility>

namespace placedpar {

Priority own_priority() { return Kernel::here().running().priority(); }

namespace {

/// The component pays for its end.
Process::Body with_end(const Process& parent, Process::Body body) {
    if (!parent.executive())
        return body;
    return [body = std::move(body)] {
        body();
        charge(Kernel::here().running(), &OperationCosts::end_component);
    };
}

} // namespace

void run_in_parallel(std::vector<Component> components, const SourceLocation& where) {
    if (components.empty())
        return;
    Kernel& kernel = Kernel::here();
    Process& self = kernel.running();
    auto others = static_cast<std::int64_t>(components.size() - 1);
    charge(self, [others](const OperationCosts& cost) { return others * cost.start_component; });
    Join join{components.size(), self};
    std::list<Process> processes;
    for (std::size_t i = 0; i < components.size(); ++i)
        processes.emplace_back(self, i, with_end(self, std::move(components[i].body)), components[i].priority, join);
    join.first_ordinal = processes.front().ordinal();
    Process& last = processes.back();
    for (Process& process : processes)
        if (&process != &last || !self.executive())
            kernel.make_ready(process);
    self.wait_for_components(last, where);
}

} // namespace placedpar
