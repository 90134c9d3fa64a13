#include "explore/process_search.hpp"

#include "explore/problems.hpp"
#include "gaprocs/processes/parameters.hpp"
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
#include <variant>

namespace placedpar {

using namespace identification;

namespace {

using Settings = std::map<std::string, Value>;

std::int64_t integer(std::size_t value) { return static_cast<std::int64_t>(value); }

/// Returns the parameters with which a searching process makes the same search as identify().
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

/// Returns all process kinds that PlacedPar knows, with these settings as the defaults of searching processes.
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

/// A parameter of a process whose value in the netlist differs from the setting of the identification.
struct Difference {
    const ProcessInstance* process;
    std::string name; ///< name of the parameter and of the setting
    Value ours;       ///< value of the setting
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
    diagnostic.message = fmt::format("{} = {} in the netlist for \"{}\", but the identification has {}", name,
                                     expression(process->parameters.at(name)), process->name, expression(ours));
    auto place = process->given.find(name);
    diagnostic.location = place == process->given.end() ? process->declared : place->second;
    diagnostic.hint = "use the same value for both: change the netlist, use --set, or give the matching option";
    throw RefusedInput(render(diagnostic));
}

bool is_val(const std::string& name, const Network& network) {
    const SetByOption* set = find_named(network.set, name);
    return set != nullptr && set->elements.empty();
}

/// Returns the names of the processes that search. Throws UserError if no process searches, or if a searching process
/// belongs to a pair of a coarse and a fine search.
std::vector<std::string> searching_processes(const Network& network, const NetlistAsked& netlist) {
    std::vector<std::string> names;
    for (const ProcessInstance& process : network.processes) {
        if (!searches(process))
            continue;
        if (breeds_recoded(process))
            throw UserError(
                fmt::format("--on {}: \"{}\" is a coarse or a fine search, for which identify has no settings; "
                            "expected a process of the kind ga.traditional, ga.master or ga.island",
                            netlist.path.string(), process.name));
        names.push_back(process.name);
    }
    if (names.empty())
        throw UserError(fmt::format(
            "--on {}: no process searches; expected a process of the kind ga.traditional, ga.master or ga.island",
            netlist.path.string()));
    return names;
}

/// Reads the netlist with these settings as the defaults of the searching processes.
ReadResult read_with(const Settings& settings, const ParsedNetlist& parsed, const Overrides& overrides,
                     const ProblemRegistry& problems) {
    ReadResult read = parsed.read(kinds_with(settings, problems), overrides);
    if (!read.network)
        throw RefusedInput(render(read));
    return read;
}

/// Reads the netlist with the settings as defaults. If a parameter in the netlist differs from the setting with the
/// same name, gives the value of the setting to the constant (`val`) with this name, and reads the netlist again.
/// Throws RefusedInput if there is no such constant, if an option sets it, or if a difference remains.
Network load_with(Settings settings, const NetlistAsked& netlist, const ProblemRegistry& problems,
                  const WarningSink& warn) {
    ReadResult read = read_with(settings, netlist.parsed, netlist.overrides, problems);
    for (const std::string& input : paths_of_inputs(*read.network))
        require_apart(std::span(&netlist.output, 1), input);
    if (searching_processes(*read.network, netlist).size() > 1) {
        settings.erase("population");
        settings.erase("stream");
        read = read_with(settings, netlist.parsed, netlist.overrides, problems);
    }
    std::size_t samples = problems.find("boom").samples();
    Overrides ours = netlist.overrides;
    while (auto difference = first_difference(*read.network, settings, samples)) {
        if (!ours.emplace(difference->name, expression(difference->ours)).second)
            refuse(*difference);
        ReadResult again = netlist.parsed.read(kinds_with(settings, problems), ours);
        if (!again.network || !is_val(difference->name, *again.network))
            refuse(*difference);
        read = std::move(again);
    }
    if (!read.diagnostics.empty())
        warn(render(read));
    return std::move(*read.network);
}

/// Returns the samples that the processes evaluate. Throws UserError if the samples are not consecutive.
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

/// Returns the number of individuals of all searches together. Throws UserError if this number is not `wanted`.
std::size_t whole_population(const Network& network, const NetlistAsked& netlist, std::size_t wanted) {
    std::int64_t sum = 0;
    for (const ProcessInstance& process : network.processes)
        if (searches(process))
            sum += std::get<std::int64_t>(process.parameters.at("population"));
    if (sum != integer(wanted))
        throw UserError(fmt::format(
            "--on {}: the netlist's searches have {} individuals in all, but the identification has {}: give "
            "--population {}, or change the netlist's populations with --set",
            netlist.path.string(), sum, wanted, sum));
    return wanted;
}

} // namespace

SearchAnswers ProcessSearch::answers() const {
    return SearchAnswers(searches, problems.find("boom").problem()->coded(coding));
}

ProcessSearch search_by_processes(const NetlistAsked& netlist, const ComplianceSearch& prepared,
                                  const IdentificationWay& way, const WarningSink& warn) {
    ProcessSearch search;
    for (const char* name : {"boom", "boom-by-voltage"})
        search.problems.add(name, make_search_problem(prepared.problem), searched_samples(prepared));
    search.network = load_with(settings_of(way), netlist, search.problems, warn);
    search.searches = searching_processes(search.network, netlist);
    search.population = whole_population(search.network, netlist, way.search.population);
    search.first = samples_for_first_generation(way);
    search.trials = way.search.window.trials;
    search.coding = way.coding;
    return search;
}

} // namespace placedpar
