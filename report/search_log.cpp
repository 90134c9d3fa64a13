#include "report/search_log.hpp"

#include "gaprocs/processes/parameters.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace placedpar {

namespace {

/// Returns the problem and the coding. Two searches can be compared only if both are equal.
std::pair<Value, Value> searched_for(const ProcessInstance& process) {
    auto value = [&](const char* parameter) {
        auto found = process.parameters.find(parameter);
        return found == process.parameters.end() ? Value() : found->second;
    };
    return {value("problem"), value("coding")};
}

void append_row(std::string& out, std::uint64_t seed, const LogRow& row) {
    auto end = std::back_inserter(out);
    fmt::format_to(end, "{},{},", seed, row.generation);
    if (row.time)
        fmt::format_to(end, "{}", static_cast<double>(row.time->count()) / 1e9); // ps to ms; at most 9 decimals
    fmt::format_to(end, ",{},{},{},{}\n", row.search, row.from, row.quantity, row.value);
}

} // namespace

bool searches(const ProcessInstance& process) {
    return process.parameters.contains("population") && process.parameters.contains("trials");
}

void require_searches(const Network& network) {
    if (std::ranges::none_of(network.processes, searches))
        throw UserError(fmt::format("no process of {} searches, so no generations can be logged; the kinds "
                                    "ga.traditional, ga.master, ga.island, ga.coarse and ga.fine search",
                                    network.source_path));
}

GenerationLog log_of(const Network& network) {
    std::vector<std::string> names;
    const ProcessInstance* first = nullptr;
    bool comparable = true;
    for (const ProcessInstance& process : network.processes)
        if (searches(process)) {
            first = first ? first : &process;
            comparable = comparable && searched_for(process) == searched_for(*first) && !breeds_recoded(process);
            names.push_back(process.name);
        }
    return GenerationLog(std::move(names), comparable);
}

std::string log_csv(std::span<const SeededLog> logs) {
    std::string out = "seed,generation,time_ms,process,from,quantity,value\n";
    for (const auto& [seed, log] : logs)
        for (const LogRow& row : log.rows())
            append_row(out, seed, row);
    return out;
}

} // namespace placedpar
