#include "explore/prediction/native_netlist.hpp"

#include "explore/load.hpp"
#include "explore/prediction/calibration.hpp"
#include "explore/problems.hpp"
#include "native/native_run.hpp"
#include "native/placement.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/names.hpp"
#include "netlist/print/print.hpp"
#include "netlist/read.hpp"
#include "text/load_source.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <string>
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

/// Returns the directive that includes a file. Throws UserError if the language cannot express the file's name.
std::string include_of(const std::filesystem::path& path) {
    const std::string name = std::filesystem::absolute(path).string();
    if (name.find_first_of("\"\\\n\r") != std::string::npos)
        throw UserError(fmt::format("{}: a netlist cannot include a file with a quotation mark, a backslash or a line "
                                    "break in its path: rename it",
                                    name));
    return fmt::format("#include \"{}\"\n", name);
}

/// Gives access to the costs in a calibration file.
class StatedCosts {
public:
    /// Throws UserError if a netlist cannot include the file.
    explicit StatedCosts(std::filesystem::path path) : path_(std::move(path)), include_(include_of(path_)) {
        if (const std::string why = why_not_a_file(path_); !why.empty())
            throw UserError(fmt::format("{}: {}", path_.string(), why));
        const ReadResult read = read_netlist_text(include_, devices_);
        if (!read.network)
            refuse("the file does not describe a computer", "\n" + render(read));
    }

    const std::string& include() const { return include_; }
    bool describes(PredictedPlaces::Kind kind) const {
        return can_use(kind == PredictedPlaces::Kind::ranks ? "this_rank probe; this_network other_probe;"
                                                            : "this_core probe; this_memory other_probe;");
    }
    /// Throws UserError unless the calibration describes places of this kind.
    void require(PredictedPlaces::Kind kind) const {
        if (!describes(kind) && kind == PredictedPlaces::Kind::ranks)
            throw UserError(
                fmt::format("{0}: the file does not describe ranks: write it by mpirun -n 2 placedpar calibrate "
                            "NETLIST -o {0}",
                            path_.string()));
        if (!describes(kind))
            refuse("the file does not describe a computer");
    }

    /// Returns the calibrated value of a process's parameter, as an expression of the netlist. Returns nothing if the
    /// parameter keeps its value.
    std::optional<std::string> value_of(const std::string& parameter, const ProcessInstance& process) const {
        if (parameter == "cycles_per_error")
            return of_problem("error", process);
        if (parameter == "cycles_per_individual")
            return of_problem("individual", process);
        if (parameter == "string_bytes" || parameter == "fitness_bytes")
            return declared("individual_bytes", "the file does not state individual_bytes");
        const bool is_cost = parameter.starts_with("cycles") || parameter == "words";
        return is_cost && process.parameters.at(parameter) != Value{0} ? std::optional<std::string>("0") : std::nullopt;
    }

private:
    std::string of_problem(const char* what, const ProcessInstance& process) const {
        const std::string* const problem = problem_of(process);
        if (!problem)
            return "0";
        return declared(val_of_problem(what, *problem),
                        fmt::format("the file has no cost of the problem \"{}\"", *problem));
    }
    /// Returns the name of a constant (`val`). Refuses a calibration that does not declare this constant.
    std::string declared(const std::string& val, const std::string& otherwise) const {
        if (!can_use(fmt::format("val probe {};", val)))
            refuse(otherwise);
        return val;
    }
    /// Returns whether a netlist that includes the calibration may contain this statement.
    bool can_use(const std::string& statement) const {
        const auto [known, is_new] = tried_.try_emplace(statement);
        if (is_new)
            known->second = read_netlist_text(include_ + statement, devices_).network.has_value();
        return known->second;
    }
    [[noreturn]] void refuse(const std::string& why, const std::string& details = "") const {
        throw UserError(
            fmt::format("{0}: {1}: write it by placedpar calibrate NETLIST -o {0}{2}", path_.string(), why, details));
    }

    Catalogue devices_;
    std::filesystem::path path_;
    std::string include_;
    mutable std::map<std::string, bool> tried_; ///< statements, and whether a netlist may contain them
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

/// The words of messages and netlists for threads, or for ranks of mpirun.
struct PlaceWords {
    native::Places places; ///< the words in messages
    const char *node, *core, *memory;
};

PlaceWords words_for(const PredictedPlaces& places) {
    if (places.kind == PredictedPlaces::Kind::ranks)
        return {{places.count, "rank", "--ranks"}, "rank", "this_rank", "this_network"};
    return {{places.count, "thread", "--threads"}, "thread", "this_core", "this_memory"};
}

/// Returns the network with its processes on simulated cores instead of its own machine.
Network on_cores(const Network& network, const PredictedPlaces& predicted) {
    const Catalogue devices;
    Network result;
    require_native(network);
    const PlaceWords words = words_for(predicted);
    const std::size_t count = predicted.count;
    const std::vector<std::size_t> place_of = native::place_nodes(network, words.places);
    const std::string name = free_name(words.node, network);
    for (std::size_t i = 0; i < count; ++i)
        result.nodes.push_back(node_of(devices, "core", words.core, fmt::format("{}[{}]", name, i)));
    result.nodes.push_back(
        node_of(devices, "shared_memory", words.memory, free_name(fmt::format("memory_of_{}s", words.node), network)));
    for (std::size_t i = 0; i < count; ++i)
        result.attachments.push_back(
            {.node = i, .bus = count, .slot = static_cast<int>(i) + 1, .name = {}, .connected = {}});
    result.processes = network.processes;
    for (ProcessInstance& process : result.processes)
        process.node = place_of[process.node];
    result.channels = network.channels;
    for (NetworkChannel& channel : result.channels)
        channel.placement = {};
    return result;
}

/// Replaces the costs in a process's parameters by statements at the end of the text.
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

std::string native_netlist(const Network& network, const PredictedPlaces& places,
                           const std::filesystem::path& calibration) {
    PredictedPlaces useful = places;
    if (places.kind == PredictedPlaces::Kind::ranks)
        native::require_enough_nodes(network, places.count);
    else
        useful.count = std::min(places.count, std::max<std::size_t>(native::most_places(network), 1));
    const StatedCosts stated(calibration);
    stated.require(places.kind);
    Network cores = on_cores(network, useful);
    std::string costs = "\n/* costs of this computer */\n";
    for (ProcessInstance& process : cores.processes)
        move_costs(process, stated, costs);
    return stated.include() + "\n" + print_cfs(cores) + costs;
}

bool describes(PredictedPlaces::Kind kind, const std::filesystem::path& calibration) {
    return StatedCosts(calibration).describes(kind);
}

std::vector<PredictedTime> predict_times(const Network& network, PredictedPlaces::Kind kind,
                                         const std::filesystem::path& calibration, std::uint64_t seed,
                                         const Interruption& interruption) {
    const ProblemRegistry problems = known_problems(seed);
    const Catalogue kinds = known_kinds(problems);
    std::vector<PredictedTime> times;
    const std::size_t most = std::max<std::size_t>(native::most_places(network), 1);
    std::size_t least = 1; // a node that states rank n needs at least n + 1 places
    for (const ProcessInstance& process : network.processes)
        least = std::max(least, network.nodes[process.node].rank.value_or(0) + 1);
    for (std::size_t places = least; places <= most && !interruption.requested();
         places += std::max<std::size_t>(1, std::bit_floor(places) / 2)) {
        const ParsedNetlist netlist = ParsedNetlist::of_text(native_netlist(network, {kind, places}, calibration));
        const Network cores = load_network(netlist, {}, kinds, [](const std::string&) {});
        times.push_back({places, run_netlist(cores, kinds, {.seed = seed}).result.time});
    }
    return times;
}

} // namespace placedpar
