#include "netlist/machine.hpp"
#include "netlist/network/names.hpp"
#include "runtime/byte_form.hpp"
#include "runtime/hardware/link_adapter.hpp"
#include "runtime/user_code.hpp"
#include "text/diagnostic.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <unordered_map>
#include <utility>

namespace placedpar {

namespace {

/// Resets `waits_since` of each process that is not in a deadlock. Such a process waits, directly or through other
/// processes, for the end of the work, and would then continue (see wait_until_work_is_over).
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

/// Returns "farm.cfs:12"; "" if there is no file.
std::string file_and_line(const Location& location) {
    if (!location.file)
        return "";
    return fmt::format("{}:{}", std::filesystem::path(location.file->path()).filename().string(), location.line);
}

/// Returns the network's process with which the path begins, before any components; null if there is none.
const ProcessInstance* outermost(const Network& network, std::string_view path) {
    return find_named(network.processes, path.substr(0, path.find('/')));
}

/// Adds the places where the netlist declares the stuck processes and channels. Also sorts the channels: first those of
/// the netlist in its order, then those that a program made.
void add_places(Deadlock& deadlock, const Network& network) {
    for (StuckProcess& stuck : deadlock.processes)
        if (const ProcessInstance* process = outermost(network, stuck.path))
            stuck.netlist = file_and_line(process->declared);
    std::unordered_map<std::string_view, std::size_t> places;
    for (const NetworkChannel& channel : network.channels)
        places.emplace(channel.name, places.size());
    auto place_of = [&](const StuckChannel& stuck) {
        auto found = places.find(stuck.name);
        return found == places.end() ? network.channels.size() : found->second;
    };
    std::ranges::stable_sort(deadlock.channels, {}, place_of);
    for (StuckChannel& stuck : deadlock.channels)
        if (std::size_t place = place_of(stuck); place < network.channels.size())
            stuck.netlist = file_and_line(network.channels[place].connected);
}

/// Returns the failed process or component, its kind, and the time unless the time is 0: "process a/1 (kind) at 3 us".
std::string failing(const Failure& failure, const ProcessInstance* process) {
    return fmt::format("process {}{}{}", failure.process, process ? " (" + process->kind + ")" : "",
                       failure.time == Time{0} ? "" : " at " + to_string(failure.time));
}

/// Returns whether the network has a device that a program adds: an exception in a process may then come from the
/// device that carries its messages.
bool has_own_devices(const Network& network) {
    return std::ranges::any_of(network.nodes, [](const Node& node) { return node.kind->is_own; });
}

/// Rethrows the current exception with the name and declaration of the process that threw it. The new exception is a
/// UserError if a user can cause the error; otherwise a logic_error, which is a defect of PlacedPar. Errors of the
/// system are rethrown unchanged.
[[noreturn]] void rethrow_with_process(const Failure& failure, const Network& network, const Catalogue& catalogue) {
    const ProcessInstance* process = outermost(network, failure.process);
    const bool is_own = (process && catalogue.find(process->kind)->is_own) || has_own_devices(network);
    std::string place = process ? process->declared.text() : "";
    std::string who = fmt::format("{}{}{}", place, place.empty() ? "" : ": ", failing(failure, process));
    try {
        throw;
    } catch (const RefusedInput& refused) {
        if (!process)
            throw;
        throw RefusedInput(refused.what() +
                           render(SecondPlace{"read by " + failing(failure, process), process->declared}));
    } catch (const hardware::BroadcastError& refused) {
        throw UserError(fmt::format("{}: {}\nhint: all channels on the bus carry one broadcast message; a "
                                    "channel that is not placed on the bus carries its own messages",
                                    who, refused.what()));
    } catch (const UserError& refused) {
        throw UserError(fmt::format("{}: {}", who, refused.what()));
    } catch (const NoMessage& received) {
        throw UserError(fmt::format("{}: {}", who, received.what()));
    } catch (const hardware::BusError& error) { // the program does not handle a fault of the machine
        throw UserError(fmt::format("{}: {}", who, error.what()));
    } catch (...) {
        const std::string why = what_was_thrown();
        if (is_own)
            throw UserError(fmt::format("{}: {}", who, why));
        try {
            throw;
        } catch (const std::system_error&) {
            throw;
        } catch (const std::bad_alloc&) {
            throw;
        } catch (...) {
            throw std::logic_error(fmt::format("{}: {}", who, why));
        }
    }
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
