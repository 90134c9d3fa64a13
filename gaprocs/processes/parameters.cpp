#include "gaprocs/processes/parameters.hpp"

#include "gaprocs/initial_population.hpp"
#include "gaprocs/policies/initial_population.hpp"
#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/spread_population.hpp"
#include "gaprocs/usual_settings.hpp"
#include "netlist/kinds/environment.hpp"
#include "text/number.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <variant>

namespace placedpar {

namespace {

std::uint32_t bytes(const ProcessEnvironment& environment, std::string_view parameter) {
    return static_cast<std::uint32_t>(environment.integer(parameter));
}

std::size_t size(const ProcessEnvironment& environment, std::string_view parameter) {
    return static_cast<std::size_t>(environment.integer(parameter));
}

template <class Step>
void set_policy(Step& usual, const std::string& text) {
    if (text != search_description::usual)
        usual = Step::named(text);
}

/// Returns the individuals with which the first population begins. The search draws the other individuals at random.
std::vector<Genome> read_initial_population(const ProcessEnvironment& environment, const SearchProblem& problem) {
    const std::string& initial = environment.text("initial");
    std::string name = initial.substr(0, initial.find('('));
    const bool is_file = std::filesystem::exists(initial); // a file takes precedence over a policy of the same name
    if (is_file || std::ranges::count(InitialPopulation::descriptions(), name, &PolicyDescription::name) == 0)
        return initial.empty() ? std::vector<Genome>() : load_population(initial, problem.representation());
    InitialPopulation begin = InitialPopulation::named(initial);
    RandomStream random = environment.random_stream(stream_name(environment) + " " + name);
    if (begin.is_spread())
        return spread_population(size(environment, "population"), problem, random);
    return begin.own() ? (*begin.own())(size(environment, "population"), problem.representation(), random)
                       : std::vector<Genome>();
}

std::size_t bits_of_field(const std::string& word) {
    std::size_t bits = parse_number<std::size_t>(word).value_or(0);
    if (bits < 1 || bits > 63)
        throw UserError(fmt::format(
            "expected the number of bits of each field, from 1 to 63 each, such as \"2 7 7\", not \"{}\"", word));
    return bits;
}

} // namespace

Split split_named(const std::string& name) {
    if (name == "individuals")
        return Split::individuals;
    if (name == "demand")
        return Split::demand;
    return Split::evaluations; // the catalogue allows no other name
}

std::uint32_t string_bytes(std::int64_t stated, const SearchProblem& problem) {
    return static_cast<std::uint32_t>(stated > 0 ? stated : static_cast<std::int64_t>((problem.bits() + 7) / 8));
}

Workload read_slave_workload(const ProcessEnvironment& environment) {
    Workload workload;
    workload.error_evaluation = Cycles{environment.integer("cycles_per_error")};
    workload.fitness_bytes = bytes(environment, "fitness_bytes");
    return workload;
}

Workload read_workload(const ProcessEnvironment& environment, const SearchProblem& problem) {
    Workload workload = read_slave_workload(environment);
    workload.genetic_operators = Cycles{environment.integer("cycles_per_individual")};
    workload.measurement_conversion = Cycles{environment.integer("cycles_per_measurement_word")};
    workload.string_bytes = string_bytes(environment.integer("string_bytes"), problem);
    workload.measurement_bytes = problem.objective() ? 0 : bytes(environment, "measurement_bytes");
    return workload;
}

Coding read_coding(const ProcessEnvironment& environment) { return Coding::named(environment.text("coding")); }

std::string stream_name(const ProcessEnvironment& environment) {
    const std::string& stream = environment.text("stream");
    return stream.empty() ? environment.process() : stream;
}

SearchSettings read_search_settings(const ProcessEnvironment& environment, const SearchProblem& problem) {
    SearchSettings settings = usual_settings(problem);
    settings.population = size(environment, "population");
    settings.crossover_probability = environment.real("crossover");
    settings.mutation_probability = environment.real("mutation");
    settings.elite = size(environment, "elite");
    set_policy(settings.reproduction, environment.text("reproduction"));
    set_policy(settings.crossover, environment.text("crossover_operator"));
    set_policy(settings.mutation, environment.text("mutation_operator"));
    settings.initial = read_initial_population(environment, problem);
    settings.window.length = size(environment, "window");
    settings.window.first = size(environment, "first_window");
    settings.window.trials = size(environment, "trials");
    settings.window.bias = environment.real("bias");
    return settings_for(problem, settings);
}

Farm::Settings read_farm_settings(const ProcessEnvironment& environment) {
    Farm::Settings settings;
    settings.bias = environment.real("bias");
    if (!environment.connected("to_slaves"))
        return settings;
    settings.slaves = size(environment, "slaves");
    settings.routes = read_routes(environment);
    settings.split = split_named(environment.text("split"));
    settings.own_share = environment.real("own_share");
    settings.sending = environment.text("sending") == "at once" ? Sending::at_once : Sending::in_turn;
    settings.tasks_under_way = size(environment, "tasks_under_way");
    settings.results_in_order = settings.split != Split::demand && environment.text("results") == "chain";
    settings.measurements_every_generation = environment.text("measurements") == "generation";
    return settings;
}

std::size_t samples_needed(const ProcessInstance& process) {
    auto samples = [&](const char* parameter) { return std::get<std::int64_t>(process.parameters.at(parameter)); };
    return static_cast<std::size_t>(std::min(samples("first_window"), samples("window")));
}

bool breeds_recoded(const ProcessInstance& process) { return process.kind == "ga.coarse" || process.kind == "ga.fine"; }

std::vector<std::size_t> bits_named(const std::string& text) {
    std::vector<std::size_t> bits;
    std::istringstream words(text);
    for (std::string word; words >> word;)
        bits.push_back(bits_of_field(word));
    if (bits.empty())
        bits_of_field(text);
    return bits;
}

Recoding read_recoding(const ProcessInstance& process) {
    auto text = [&](const char* parameter) { return std::get<std::string>(process.parameters.at(parameter)); };
    Recoding recoding{.problem_bits = bits_named(text("fields")),
                      .bits = bits_named(text("bits")),
                      .coding = Coding::named(text("coding"))};
    if (process.kind == "ga.fine")
        recoding.around = Genome(recoding.problem_length());
    recoding.validate();
    return recoding;
}

} // namespace placedpar
