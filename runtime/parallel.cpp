#include "runtime/parallel.hpp"

#include "runtime/executive.hpp"
#include "runtime/kernel.hpp"

#include <list>

namespace placedpar {

Priority own_priority() { return Kernel::here().running().priority(); }

void run_in_parallel(std::vector<Component> components, const SourceLocation& where) {
    if (components.empty())
        return;
    Kernel& kernel = Kernel::here();
    Process& self = kernel.running();
    auto n = static_cast<std::int64_t>(components.size());
    charge(self, [n](const OperationCosts& cost) { return n * (cost.start_component + cost.end_component); });
    Join join{components.size(), self};
    std::list<Process> processes;
    for (std::size_t i = 0; i < components.size(); ++i)
        processes.emplace_back(self, i, std::move(components[i].body), components[i].priority, join);
    join.first_ordinal = processes.front().ordinal();
    for (Process& process : processes)
        kernel.make_ready(process);
    self.wait_for(Activity::joining, nullptr, where);
}

} // namespace placedpar
