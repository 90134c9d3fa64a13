#include "explore/process_search.hpp"

#include "explore/problems.hpp"
#include "gaprocs/search_problem.hpp"
#include "netlist/network/names.hpp"
#include "report/search_log.hpp"
#include "text/diagnostic.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <utility>

namespace placedpar {

using namespace identification;

namespace {

using Settings = std::map<std::string, Value>;

std::int64_t integer(std::size_t value) { return static_cast<std::int64_t>(value); }

/// Returns the parameters that make a searching process do what identify() does.
Settings settings_of(const IdentificationWay& way) {
    const SearchSettings& search = way.search;
    return {{"population", integer(search.population)},
            {"window", integer(search.window.length)},
            {"first_window", integer(samples_for_first_generation(way))},
            {"trials", integer(search.window.trials)},
            {"bias", search.window.bias},
            {"crossover", search.crossover_probability},
            {"mutation", search.mutation_probability},
            {"elite", integer(search.elite)},
            {"reproduction", search.reproduction.text()},
            {"coding", way.coding.text()},
            {"stream", std::string("master")}};
}

/// Returns the value as text for --set.
std::string expression(const Value& value) {
    if (const auto* text = std::get_if<std::string>(&value))
        return fmt::format("\"{}\"", *text);
    return std::visit([](const auto& number) { return fmt::format("{}", number); }, value);
}

/// Returns the program's kinds, with these settings as the defaults of searching processes.
Catalogue kinds_with(const Settings& settings, const ProblemRegistry& problems) {
    Catalogue program = known_kinds(problems), catalogue;
    for (auto [name, kind] : program.kinds()) {
        if (kind.parameter("population") && kind.parameter("trials"))
            for (ParameterDescription& parameter : kind.parameters)
                if (auto ours = settings.find(parameter.name); ours != settings.end())
                    parameter.default_value = ours->second;
        catalogue.add(std::move(kind));
    }
    return catalogue;
}

/// A setting that the netlist fixes to another value.
struct Difference {
    const ProcessInstance* process;
    std::string name;
    Value ours;
};

std::optional<Difference> first_difference(const Network& network, const Settings& settings, std::size_t samples) {
    for (const ProcessInstance& process : network.processes) {
        Settings wanted = searches(process) ? settings : Settings{};
        if (process.kind == "ga.host" && process.parameters.at("samples") != Value(integer(samples)))
            wanted["samples"] = std::int64_t{0};
        for (const auto& [name, ours] : wanted)
            if (process.parameters.at(name) != ours)
                return Difference{&process, name, ours};
    }
    return std::nullopt;
}

[[noreturn]] void refuse(const Difference& difference) {
    const auto& [process, name, ours] = difference;
    Diagnostic diagnostic;
    diagnostic.message = fmt::format("{} = {} in the netlist for \"{}\", but identify searches with {}", name,
                                     expression(process->parameters.at(name)), process->name, expression(ours));
    auto place = process->given.find(name);
    diagnostic.location = place == process->given.end() ? process->declared : place->second;
    diagnostic.hint =
        "use the same value for both: change the netlist, use --set, or give identify the matching option";
    throw RefusedInput(render(diagnostic));
}

bool is_val(const std::string& name, const Network& network) {
    const SetByOption* set = find_named(network.set, name);
    return set != nullptr && set->elements.empty();
}

/// Reads the netlist with the settings. A setting that the netlist fixes to another value is set by the val of its
/// name; without such a val the netlist is refused.
Network load_with(const Settings& settings, const NetlistAsked& netlist, const ProblemRegistry& problems,
                  const WarningSink& warn) {
    const Catalogue catalogue = kinds_with(settings, problems);
    const ParsedNetlist parsed(netlist.path, netlist.options);
    ReadResult read = parsed.read(catalogue, netlist.overrides);
    if (!read.network)
        throw RefusedInput(render(read));
    std::size_t samples = problems.find("boom").samples();
    Overrides ours = netlist.overrides;
    while (auto difference = first_difference(*read.network, settings, samples)) {
        if (!ours.emplace(difference->name, expression(difference->ours)).second)
            refuse(*difference);
        ReadResult again = parsed.read(catalogue, ours);
        if (!again.network || !is_val(difference->name, *again.network))
            refuse(*difference);
        read = std::move(again);
    }
    if (!read.diagnostics.empty())
        warn(render(read));
    return std::move(*read.network);
}

/// Returns the samples to be searched. Throws if they are not consecutive.
std::vector<Sample> searched_samples(const ComplianceSearch& prepared) {
    std::vector<Sample> record;
    for (const hydraulics::CircuitSample& sample : prepared.samples) {
        if (sample.stretch != prepared.samples.front().stretch)
            throw UserError(fmt::format("--on: the record has a gap before {:.3f} s, which the netlist's "
                                        "processes cannot handle; --samples {} ends before the gap",
                                        sample.time_s, record.size()));
        record.push_back(sample.values());
    }
    return record;
}

std::string searching_process(const Network& network, const std::filesystem::path& netlist) {
    auto first = std::ranges::find_if(network.processes, searches);
    auto count = std::ranges::count_if(network.processes, searches);
    if (count != 1)
        throw UserError(
            fmt::format("--on {}: {} processes of the netlist search, expected one: ga.traditional, or ga.master "
                        "with its slaves",
                        netlist.string(), count));
    return first->name;
}

} // namespace

std::vector<double> ProcessSearch::compliances(const RunReport& report) const {
    std::vector<double> found;
    for (const std::string& name : problems.find("boom").problem()->parameter_names())
        found.push_back(report.measured(master, name));
    return found;
}

ProcessSearch search_by_processes(const NetlistAsked& netlist, const ComplianceSearch& prepared,
                                  const IdentificationWay& way, const WarningSink& warn) {
    ProcessSearch search;
    search.problems.add("boom", make_search_problem(prepared.problem), searched_samples(prepared));
    search.network = load_with(settings_of(way), netlist, search.problems, warn);
    for (const std::string& included : search.network.included_paths)
        require_apart(std::span(&netlist.output, 1), included);
    search.master = searching_process(search.network, netlist.path);
    return search;
}

} // namespace placedpar
