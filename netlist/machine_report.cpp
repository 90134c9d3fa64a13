#include "netlist/failed_process.hpp"
#include "netlist/machine.hpp"
#include "netlist/network/names.hpp"
#include "text/user_error.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace placedpar {

namespace {

/// Resets `waits_since` of each process that waits, but is not in a deadlock. Such a process waits, directly or through
/// other processes, for the end of the run's work, and would then continue (see wait_until_work_is_over).
void forget_waits_that_end(RunReport& report) {
    auto is_held = [&](const ProcessUse& process) {
        const auto& stuck = report.result.deadlock->processes;
        return std::any_of(stuck.begin(), stuck.end(), [&](const StuckProcess& each) {
            return each.path == process.name ||
                   each.path.starts_with(process.name + "/"); // the process or one of its components
        });
    };
    for (ProcessUse& process : report.processes)
        if (report.result.ending == Ending::completed || (report.result.ending == Ending::stuck && !is_held(process)))
            process.waits_since.reset();
}

/// Rethrows an exception that no process threw. The end of virtual time becomes a UserError.
[[noreturn]] void rethrow_for_the_kernel() {
    try {
        throw;
    } catch (const std::overflow_error& beyond_the_end_of_time) {
        throw UserError(beyond_the_end_of_time.what());
    }
}

} // namespace

RunReport Machine::run(Time limit) {
    RunReport report;
    std::vector<ProgramWait> waits;
    auto count_work = [&] {
        for (std::size_t i = 0; i < parts_.nodes.size(); ++i)
            ask(i, &MachineNode::report, report);
        report.links = link_uses();
        report.processes = process_uses();
        report.faults = fault_uses();
    };
    try {
        report.result = simulation_.run(limit, count_work);
    } catch (...) {
        if (simulation_.who_failed())
            rethrow_with_process(*simulation_.who_failed(), network_, software_.catalogue());
        rethrow_for_the_kernel();
    }
    forget_waits_that_end(report);
    if (report.result.deadlock) {
        if (report.result.ending == Ending::stuck)
            for (std::size_t i = 0; i < parts_.nodes.size(); ++i)
                std::ranges::move(ask(i, &MachineNode::program_waits), std::back_inserter(waits));
        add_program_waits(*report.result.deadlock, waits, network_);
        add_places(*report.result.deadlock, network_);
    }
    const std::uint64_t events = report.result.fingerprint;
    report.result.fingerprint = fingerprint_with(events, software_.measurements());
    report.measurements = software_.measurements();
    if (record_) {
        record_->report = report;
        record_->events = events;
    }
    report.measurements = in_order_of_netlist(std::move(report.measurements), network_);
    return report;
}

std::vector<LinkUse> Machine::link_uses() const {
    std::vector<LinkUse> uses;
    for (std::size_t i = 0, wires = network_.count_wires(); i < wires; ++i) {
        const LinkConnection& connection = network_.connections[i];
        auto a = link_name(network_.nodes, connection.a), b = link_name(network_.nodes, connection.b);
        auto add = [&](const std::string& from, const std::string& to, const hardware::LinkDirection& direction) {
            uses.push_back({from, to, direction.bytes_carried(), direction.time_occupied()});
        };
        add(a, b, parts_.links[i]->from_a_to_b());
        add(b, a, parts_.links[i]->from_b_to_a());
    }
    return uses;
}

std::vector<ProcessUse> Machine::process_uses() const {
    std::vector<ProcessUse> uses;
    for (std::size_t i = 0; i < network_.processes.size(); ++i)
        uses.push_back({network_.processes[i].name, network_.nodes[network_.processes[i].node].name,
                        software_.processes()[i]->time_waited(), software_.processes()[i]->waits_since()});
    return uses;
}

} // namespace placedpar
