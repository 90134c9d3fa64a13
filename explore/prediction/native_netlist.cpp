#include "explore/prediction/native_netlist.hpp"

#include "explore/load.hpp"
#include "explore/prediction/calibration.hpp"
#include "explore/problems.hpp"
#include "native/native_run.hpp"
#include "native/placement.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/names.hpp"
#include "netlist/print/print.hpp"
#include "text/load_source.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace placedpar {

namespace {

const std::string* problem_of(const ProcessInstance& process) {
    const auto problem = process.parameters.find("problem");
    return problem == process.parameters.end() ? nullptr : std::get_if<std::string>(&problem->second);
}

std::string text_of_calibration(const std::filesystem::path& path) {
    const LoadedSource loaded = load_source(path);
    if (!loaded.problems.empty())
        throw UserError(render(loaded.problems));
    return loaded.file->text();
}

/// The costs that a calibration states.
class StatedCosts {
public:
    explicit StatedCosts(const std::filesystem::path& path) : path_(path), text_(text_of_calibration(path)) {
        require("define core", "it does not describe a computer");
    }

    /// Returns the value of a parameter of a process, as an expression of the netlist; nothing if the process keeps its
    /// value.
    std::optional<std::string> value_of(const std::string& parameter, const ProcessInstance& process) const {
        if (parameter == "cycles_per_error")
            return of_problem("error", process);
        if (parameter == "cycles_per_individual")
            return of_problem("individual", process);
        if (parameter == "string_bytes" || parameter == "fitness_bytes")
            return "individual_bytes";
        const bool is_cost = parameter.starts_with("cycles") || parameter == "words";
        return is_cost && process.parameters.at(parameter) != Value{0} ? std::optional<std::string>("0") : std::nullopt;
    }

private:
    std::string of_problem(const char* what, const ProcessInstance& process) const {
        const std::string* const problem = problem_of(process);
        if (!problem)
            return "0";
        const std::string val = val_of_problem(what, *problem);
        require("val " + val + " ", fmt::format("it has no cost of the problem \"{}\"", *problem));
        return val;
    }
    void require(const std::string& words, const std::string& otherwise) const {
        if (text_.find(words) == std::string::npos)
            throw UserError(
                fmt::format("{0}: {1}: write it by placedpar calibrate NETLIST -o {0}", path_.string(), otherwise));
    }

    std::filesystem::path path_;
    std::string text_;
};

/// Returns a name that no process has.
std::string free_name(std::string name, const Network& network) {
    while (std::ranges::any_of(network.processes,
                               [&](const ProcessInstance& process) { return base_name(process.name) == name; }))
        name += '_';
    return name;
}

Node node_of(const Catalogue& devices, std::string_view model, std::string type, std::string name) {
    Node node = devices.node_types().find(model)->second.preset;
    node.type = std::move(type);
    node.name = std::move(name);
    return node;
}

/// Returns the network with its processes on cores, without the costs that its parameters state.
Network on_cores(const Network& network, std::size_t threads) {
    const Catalogue devices;
    Network result;
    require_native(network);
    const std::vector<std::size_t> thread_of = native::place_nodes(network, {threads});
    const std::string thread = free_name("thread", network);
    for (std::size_t i = 0; i < threads; ++i)
        result.nodes.push_back(node_of(devices, "core", "this_core", fmt::format("{}[{}]", thread, i)));
    result.nodes.push_back(node_of(devices, "shared_memory", "this_memory", free_name("memory_of_threads", network)));
    for (std::size_t i = 0; i < threads; ++i)
        result.attachments.push_back(
            {.node = i, .bus = threads, .slot = static_cast<int>(i) + 1, .name = {}, .connected = {}});
    result.processes = network.processes;
    for (ProcessInstance& process : result.processes)
        process.node = thread_of[process.node];
    result.channels = network.channels;
    for (NetworkChannel& channel : result.channels)
        channel.placement = {};
    return result;
}

/// Moves the costs of a process from its parameters to the end of the text.
void move_costs(ProcessInstance& process, const StatedCosts& costs, std::string& text) {
    std::string list;
    for (const auto& [parameter, stated] : process.parameters)
        if (const auto value = costs.value_of(parameter, process)) {
            std::erase(process.given_in_order, parameter);
            list += fmt::format("{}{} = {}", list.empty() ? "" : ", ", parameter, *value);
        }
    if (!list.empty())
        text += fmt::format("{} ({});\n", process.name, list);
}

} // namespace

std::vector<std::string> problems_of(const Network& network) {
    std::vector<std::string> problems;
    for (const ProcessInstance& process : network.processes)
        if (const std::string* const problem = problem_of(process);
            problem && std::ranges::count(problems, *problem) == 0)
            problems.push_back(*problem);
    return problems;
}

std::string native_netlist(const Network& network, std::size_t threads, const std::filesystem::path& calibration) {
    threads = std::min(threads, std::max<std::size_t>(native::most_places(network), 1));
    Network cores = on_cores(network, threads);
    const StatedCosts stated(calibration);
    std::string costs = "\n/* costs of this computer */\n";
    for (ProcessInstance& process : cores.processes)
        move_costs(process, stated, costs);
    return fmt::format("#include \"{}\"\n\n", std::filesystem::absolute(calibration).string()) + print_cfs(cores) +
           costs;
}

std::vector<ThreadsTime> predict_threads(const Network& network, const std::filesystem::path& calibration,
                                         std::uint64_t seed, const Interruption& interruption) {
    const ProblemRegistry problems = known_problems(seed);
    const Catalogue kinds = known_kinds(problems);
    std::vector<ThreadsTime> times;
    const std::size_t most = std::max<std::size_t>(native::most_places(network), 1);
    std::size_t least = 1; // a node with a rank needs its thread
    for (const ProcessInstance& process : network.processes)
        least = std::max(least, network.nodes[process.node].rank.value_or(0) + 1);
    for (std::size_t threads = least; threads <= most && !interruption.requested();
         threads += std::max<std::size_t>(1, std::bit_floor(threads) / 2)) {
        const ParsedNetlist netlist = ParsedNetlist::of_text(native_netlist(network, threads, calibration));
        const Network cores = load_network(netlist, {}, kinds, [](const std::string&) {});
        times.push_back({threads, run_netlist(cores, kinds, {.seed = seed}).result.time});
    }
    return times;
}

} // namespace placedpar
