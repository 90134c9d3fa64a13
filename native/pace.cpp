#include "native/pace.hpp"

#include "netlist/kinds/device_kind.hpp"
#include "runtime/kernel.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace placedpar::native {

namespace {

/// The costs of operations. An operation that a polling process repeats takes one cycle, so that other processes can
/// run. All other operations take no time.
constexpr OperationCosts costs_of_polls{.timer_wait_past = Cycles{1}, .alternation_end = Cycles{1}};

/// The end time of a computation that is too long for a Time.
constexpr Time last_moment = Time::max() - Time{1};

/// Returns how long a cycle of the node's processor takes in the run; zero if its processes compute in no time.
Time paced_cycle(const Network& network, std::size_t node, double pace) {
    if (!executes_in_time(network, node) || !network.nodes[node].attributes.contains("clock"))
        return {};
    const double cycle = 1e12 / static_cast<double>(network.nodes[node].integer("clock")) / pace;
    return clamped(static_cast<WideInteger>(std::ceil(std::min(cycle, 1e18))));
}

} // namespace

Pace::Pace(Kernel& kernel, const Network& network, double pace) : Executive("paced", costs_of_polls), kernel_(kernel) {
    for (const ProcessInstance& process : network.processes) {
        const auto made = processors_.try_emplace(process.node, kernel, paced_cycle(network, process.node, pace)).first;
        of_process_[process.name] = &made->second;
    }
}

Pace::Processor& Pace::processor_of(const Process& process) { return *of_process_.at(process.outermost().name()); }

bool Pace::begin_computing(Process& self, Cycles cycles, const CodeShape&) {
    if (cycles < Cycles{0})
        throw std::logic_error("process " + self.path() + " computes for a negative number of cycles");
    Processor& processor = processor_of(self);
    const Time takes = times(static_cast<std::int64_t>(cycles), processor.cycle);
    if (takes == Time{})
        return true;
    if (processor.computations.empty() && processor.last != &self)
        processor.until = kernel_.now();
    processor.computations.push_back({&self, takes});
    if (processor.computations.size() == 1)
        processor.begin_first();
    return false;
}

void Pace::Processor::begin_first() {
    until = std::min(later(until, computations.front().takes), last_moment);
    kernel.future().schedule(*this, std::max(until, kernel.now()), EventQueue::turn);
}

void Pace::Processor::happen() noexcept {
    Process& process = *computations.front().process;
    computations.pop_front();
    last = &process;
    kernel.enqueue(process);
    if (!computations.empty())
        begin_first();
}

void Pace::make_ready(Process& process) { kernel_.enqueue(process); }

void Pace::leave(Process& process, Process* successor) {
    Processor& processor = processor_of(process);
    if (processor.last == &process)
        processor.last = nullptr;
    if (successor)
        make_ready(*successor);
}

} // namespace placedpar::native
