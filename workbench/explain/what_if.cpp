#include "workbench/explain/what_if.hpp"

#include "text/user_error.hpp"
#include "workbench/problems.hpp"
#include "workbench/workers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

namespace placedpar {

namespace {

constexpr std::int64_t fastest = 1'000'000'000; ///< that the language takes

struct Factor {
    const char* faster;
    const char* less;
    double by; ///< 0: as fast as can be said
};
constexpr std::array<Factor, 3> factors{{
    {.faster = "10 % faster", .less = "a tenth less", .by = 1.1},
    {.faster = "twice as fast", .less = "half", .by = 2},
    {.faster = "as fast as can be", .less = "none", .by = 0},
}};

std::string faster(std::int64_t rate, const Factor& factor) {
    auto wanted = static_cast<std::int64_t>(std::llround(static_cast<double>(rate) * factor.by));
    return std::to_string(factor.by == 0 ? fastest : std::min(wanted, fastest));
}

/// A tenth faster is a time of 1 / 1.1; here it is said of the constant itself.
std::string less(std::int64_t constant, const Factor& factor) {
    double share = factor.by == 0 ? 0 : factor.by == 2 ? 0.5 : 0.9;
    return std::to_string(std::llround(static_cast<double>(constant) * share));
}

std::string array_of(const std::string& name) { return name.substr(0, name.find('[')); }

/// Nodes by what runs on them: "master[]" for an array, and each alone.
std::map<std::string, std::set<std::size_t>> groups_of(const Network& network) {
    std::map<std::string, std::set<std::size_t>> groups;
    for (const ProcessInstance& process : network.processes)
        if (process.node != nowhere && network.nodes[process.node].attributes.contains("clock"))
            groups["the processors of " + array_of(process.name)].insert(process.node);
    for (std::size_t node = 0; node < network.nodes.size(); ++node)
        if (network.nodes[node].attributes.contains("clock")) {
            groups["processor " + network.nodes[node].name] = {node};
            groups["all processors"].insert(node);
        }
    return groups;
}

void add_processors(const Network& network, std::vector<Change>& changes) {
    std::set<std::set<std::size_t>> known;
    for (const auto& [name, nodes] : groups_of(network))
        if (known.insert(nodes).second)
            for (const Factor& factor : factors) {
                Change change{fmt::format("{} {}", name, factor.faster), {}};
                for (std::size_t node : nodes)
                    change.set[network.nodes[node].name + ".clock"] =
                        faster(network.nodes[node].integer("clock"), factor);
                changes.push_back(std::move(change));
            }
}

void add_links(const Network& network, std::vector<Change>& changes) {
    std::set<std::int64_t> speeds;
    for (const LinkConnection& connection : network.connections)
        if (!connection.over_bus)
            speeds.insert(connection.bits_per_second);
    if (speeds.size() == 1)
        for (const Factor& factor : factors)
            changes.push_back(
                {fmt::format("all links {}", factor.faster), {{"linkspeed", faster(*speeds.begin(), factor)}}});
}

bool is_cost(const std::string& name) {
    return name.find("cycles") != std::string::npos || name.find("bytes") != std::string::npos || name == "channelcall";
}

/// Of those costs that have the same value wherever they are.
template <class Map>
void note_costs(const Map& values, std::map<std::string, std::set<std::int64_t>>& costs) {
    for (const auto& [name, value] : values)
        if (const auto* integer = std::get_if<std::int64_t>(&value); integer && is_cost(name) && *integer > 0)
            costs[name].insert(*integer);
}

void add_costs(const Network& network, std::vector<Change>& changes) {
    std::map<std::string, std::set<std::int64_t>> costs;
    for (const Node& node : network.nodes)
        note_costs(node.attributes, costs);
    for (const ProcessInstance& process : network.processes)
        note_costs(process.parameters, costs);
    for (const auto& [name, values] : costs)
        if (values.size() == 1)
            for (const Factor& factor : factors)
                changes.push_back({fmt::format("{} {}", name, factor.less), {{name, less(*values.begin(), factor)}}});
}

std::string text_of(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The vals that a file gives a plain number.
std::map<std::string, std::int64_t> plain_vals(const std::string& text) {
    static const std::regex declaration(R"((?:^|\n)\s*val\s+(\w+)\s+(\d{1,9})\s*;)");
    std::map<std::string, std::int64_t> vals;
    for (std::sregex_iterator found(text.begin(), text.end(), declaration), end; found != end; ++found)
        vals[(*found)[1]] = std::stoll((*found)[2]);
    return vals;
}

/// Whether the change makes other processes.
bool replicates(const Network& network, const Change& change, const ChangedNetlist& read) {
    try {
        return read(change.set).processes.size() != network.processes.size();
    } catch (const UserError&) {
        return false;
    }
}

void add_vals(const Network& network, const ChangedNetlist& read, std::vector<Change>& changes) {
    std::vector<std::string> paths = network.included_paths;
    paths.push_back(network.source_path);
    for (const std::string& path : paths)
        for (auto [name, value] : plain_vals(text_of(path))) {
            for (const SetByOption& set : network.set)
                if (set.name == name)
                    value = std::atoll(set.value.c_str());
            Change more{fmt::format("one more: {} {} instead of {}", name, value + 1, value),
                        {{name, std::to_string(value + 1)}}};
            if (replicates(network, more, read))
                changes.push_back(std::move(more));
        }
}

Answer try_out(const Change& change, const ChangedNetlist& read, std::uint64_t seed, Time until) {
    try {
        RunReport report = run_netlist(read(change.set), known_problems(seed), {.seed = seed, .until = until});
        return {change, report.result.ending, report.result.time};
    } catch (const UserError& refused) {
        return {.change = change, .refused = refused.what()};
    }
}

} // namespace

std::vector<Change> changes_of(const Network& network, const ChangedNetlist& read) {
    std::vector<Change> changes;
    add_processors(network, changes);
    add_links(network, changes);
    add_costs(network, changes);
    add_vals(network, read, changes);
    return changes;
}

std::vector<Answer> try_out(const std::vector<Change>& changes, const ChangedNetlist& read, std::uint64_t seed,
                            Time until) {
    std::vector<Answer> answers(changes.size());
    std::atomic<std::size_t> next{0};
    on_workers(count_cores(), [&](std::size_t) {
        for (std::size_t i; (i = next++) < changes.size();)
            answers[i] = try_out(changes[i], read, seed, until);
    });
    std::erase_if(answers, [](const Answer& answer) { return !answer.refused.empty(); });
    std::ranges::stable_sort(answers, {}, [](const Answer& a) { return std::pair(a.ending, a.time); });
    return answers;
}

} // namespace placedpar
