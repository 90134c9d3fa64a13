#include "native/run_parts.hpp"

#include "netlist/failed_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace placedpar::native {

namespace {

Ending common_ending(const std::vector<RunPart>& parts) {
    for (const Ending how : {Ending::interrupted, Ending::stuck})
        if (std::ranges::any_of(parts, [how](const RunPart& part) { return part.result.ending == how; }))
            return how;
    return Ending::completed;
}

RunResult common_result(std::vector<RunPart>& parts) {
    RunResult common;
    common.ending = common_ending(parts);
    for (RunPart& part : parts) {
        common.time = std::max(common.time, part.result.time);
        if (part.result.deadlock)
            common.deadlock = std::move(part.result.deadlock);
        std::ranges::copy(part.result.never_ran, std::back_inserter(common.never_ran));
    }
    return common;
}

std::vector<MessagesBetween> messages_between(const std::vector<RunPart>& parts, const std::string& noun) {
    std::vector<MessagesBetween> all;
    for (std::size_t from = 0; from < parts.size(); ++from)
        for (std::size_t to = 0; to < parts[from].sent.size(); ++to)
            if (const Traffic& sent = parts[from].sent[to]; sent.messages > 0)
                all.push_back(
                    {fmt::format("{} {}", noun, from), fmt::format("{} {}", noun, to), sent.messages, sent.bytes});
    return all;
}

} // namespace

std::vector<Time> times_waited(const Software& software) {
    std::vector<Time> waited;
    for (const Process* process : software.processes())
        waited.push_back(process ? process->time_waited() : Time{});
    return waited;
}

void sort_by_netlist(std::vector<StuckProcess>& stuck, const Network& network) {
    const auto place = [&](const StuckProcess& each) {
        const std::string name = each.path.substr(0, each.path.find('/'));
        return std::ranges::find(network.processes, name, &ProcessInstance::name) - network.processes.begin();
    };
    std::ranges::stable_sort(stuck, {}, place);
}

RunReport join_parts(const Network& network, const std::vector<std::size_t>& place_of_node, const std::string& noun,
                     std::vector<RunPart> parts) {
    RunReport report;
    report.is_native = true;
    report.result = common_result(parts);
    report.messages = messages_between(parts, noun);
    std::vector<Measurement> measurements;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        std::ranges::move(parts[i].measurements, std::back_inserter(measurements));
        const Time busy = std::max(parts[i].result.time - parts[i].rested, Time{});
        report.processors.push_back({fmt::format("{} {}", noun, i), noun, busy, Time{}});
    }
    report.measurements = in_order_of_netlist(std::move(measurements), network);
    for (std::size_t i = 0; i < network.processes.size(); ++i) {
        const std::size_t place = place_of_node[network.processes[i].node];
        report.processes.push_back(
            {network.processes[i].name, fmt::format("{} {}", noun, place), parts[place].waited[i], std::nullopt});
    }
    if (report.result.deadlock) {
        sort_by_netlist(report.result.deadlock->processes, network);
        add_places(*report.result.deadlock, network);
    }
    return report;
}

} // namespace placedpar::native
