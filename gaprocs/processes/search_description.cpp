#include "gaprocs/processes/search_description.hpp"

#include "gaprocs/fitness.hpp"
#include "gaprocs/policies/coding.hpp"
#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/initial_population.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "gaprocs/policies/reproduction.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/settings.hpp"
#include "netlist/kinds/description.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace placedpar::search_description {

namespace {

Parameters population_parameters() {
    using namespace description;
    return {
        problem(),
        integer("population", {.unit = "individuals", .by_default = 120, .least = 2, .most = largest_population},
                "size of this process's population (thesis 4.3: 120 in all)"),
        deciding("window", integer("window", {.unit = "samples", .by_default = 10, .least = 1, .most = 1024},
                                   "samples over which the fitness is summed (eq. 3.9)")),
        deciding("window", integer("first_window", {.unit = "samples", .by_default = 5, .least = 1, .most = 1024},
                                   "samples that the first generation waits for; if the window is shorter, the "
                                   "generation waits until the window is full")),
        deciding("window", integer("trials", {.unit = "generations", .by_default = 5, .least = 1, .most = 1e6},
                                   "generations for each new sample (thesis 4.3)")),
    };
}

/// Checks that the text names a file or a policy. An empty text selects the first policy.
void check_initial(const std::string& text) {
    if (text.empty() || std::filesystem::exists(text))
        return;
    try {
        InitialPopulation::named(text);
    } catch (const UserError& no_policy) {
        throw UserError(fmt::format("the text is neither the name of a file nor a policy: {}", no_policy.what()));
    }
}

ParameterDescription initial() {
    auto description =
        policy<InitialPopulation>("initial", InitialPopulation().text(),
                                  "the first population: a policy, or a file with a string in each line; if the file "
                                  "has too few strings, the others are drawn at random");
    description.check = check_initial;
    return description;
}

Parameters operator_parameters() {
    using namespace description;
    return {
        deciding("fitness",
                 real("bias",
                      {.unit = "(unit of the error)^2", .by_default = 400, .least = 1e-300, .most = fitness_term_limit},
                      "B of the fitness (eq. 3.9)")),
        deciding("crossover", real("crossover", {.by_default = 0.8, .least = 0, .most = 1},
                                   "probability that a pair is crossed over")),
        deciding("mutation",
                 real("mutation", {.by_default = 0.01, .least = 0, .most = 1},
                      "probability that a bit is flipped, or a number or an element of a permutation changed")),
        deciding(
            "elitism",
            integer(
                "elite", {.unit = "individuals", .by_default = 0, .least = 0, .most = 1e6},
                "best individuals that are copied unchanged, and evaluated again in every generation (thesis: none)")),
        usual_policy<Reproduction>(
            "reproduction",
            "how parents are chosen (usual: roulette, as in the thesis; ranking for a problem without a record)"),
        usual_policy<Crossover>("crossover_operator",
                                "how two parents make two offspring (usual: one-point, as in the thesis; "
                                "blend for real numbers, order for permutations)"),
        usual_policy<Mutation>("mutation_operator", "how a bit, number or element is mutated (usual: bit, as in the "
                                                    "thesis; gaussian for real numbers, inversion for permutations)"),
        policy<Coding>(
            "coding", Coding().text(),
            "how a field of the string codes a number (thesis: natural); slaves use the coding of their master"),
        initial(),
        text("stream", {.by_default = ""}, "name of the random stream; the process's own name if empty"),
    };
}

Parameters workload_parameters() {
    using namespace description;
    return {
        cycles_per_error(),
        integer("cycles_per_individual", {.unit = "cycles", .by_default = 1750, .least = 0, .most = 1e9},
                "workload: the genetic operators, for one individual"),
        integer("cycles_per_measurement_word", {.unit = "cycles", .by_default = 0, .least = 0, .most = 1e9},
                "workload: preparing a word of the measurements for sending"),
    };
}

} // namespace

Parameters operator+(Parameters first, const Parameters& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

ParameterDescription problem() {
    return description::text("problem", {.by_default = "boom"}, "the search problem and its record of measurements");
}

ParameterDescription cycles_per_error() {
    auto parameter =
        description::integer("cycles_per_error", {.unit = "cycles", .by_default = 1440, .least = 0, .most = 1e9},
                             "workload: computing one individual's error at one sample");
    parameter.computes_reals = true;
    return parameter;
}

ParameterDescription bytes_in_message(std::string name, std::int64_t by_default, std::string about) {
    return description::integer(std::move(name), {.unit = "bytes", .by_default = by_default, .least = 1, .most = 65536},
                                std::move(about));
}

ParameterDescription fitness_bytes() {
    return bytes_in_message("fitness_bytes", 2, "size of an individual's fitness in a message");
}

Parameters search_parameters() {
    return population_parameters() + operator_parameters() + workload_parameters() +
           Parameters{
               description::integer(
                   "string_bytes", {.unit = "bytes", .by_default = 0, .least = 0, .most = 65536},
                   "size of an individual's string in a message; 0: the length of the problem's string in whole bytes, "
                   "with 8 bytes for each real number or element of a permutation"),
               fitness_bytes(),
               bytes_in_message("measurement_bytes", 148, "size of a window's measurements in a message (appendix E)")};
}

std::vector<MeasurementDescription> search_measurements() {
    std::vector<MeasurementDescription> all{
        {"T_exe", "ms",
         "mean time of a generation with a full window; all times are absent if the window was never full"},
        {"T_sr", "ms", "time from the first send to the last receive of a generation"},
        {"P_time2", "ms", "time of the process's own share of the error evaluations"},
        {"C_time2", "ms", "communication time of a generation with new measurements and nothing to evaluate"},
        {"S_time2", "ms", "time of the genetic operators"},
        {"generations", "", "generations evaluated"},
        {"generations_per_second", "1/s",
         "generations of this process's own population per second, including the time for new samples; absent if "
         "generations take no time"},
        {"populations", "", "a hash over all populations in order: equal in two runs if all generations are equal"},
    };
    for (MeasurementDescription& each : individual_measurements("the last generation's best individual"))
        all.push_back(std::move(each));
    return all;
}

std::vector<MeasurementDescription> individual_measurements(const std::string& whose) {
    return {
        {"best_fitness", "(unit of the error)^2", "fitness of " + whose},
        {"best_objective", "the problem's", "for a problem without a record: the best objective of all generations"},
        {"violation", "", "for a problem with constraints: total violation of the constraints by that individual"},
        {"known_optimum", "the problem's", "the best possible objective, if the problem knows it"},
        {"the problem's parameters", "", "as decoded from " + whose},
    };
}

PortDescription from_host() {
    return description::input<HostMessage>("from_host", "host message", "the samples of the record");
}

PortDescription to_host() {
    return description::optional(description::output<EstimateMessage>(
        "to_host", "estimate",
        "the search's best individual after the last generation of each sample; for the host that sends the samples"));
}

Parameters farm_parameters() {
    using namespace description;
    return {
        deciding("farm", integer("slaves", {.by_default = 1, .least = 1, .most = 4096},
                                 "number of connected slaves; ignored if no slave is connected")),
        deciding("farm",
                 text("split", {.by_default = "individuals", .choices = {"individuals", "demand", "evaluations"}},
                      "how evaluations are dealt out: to each slave, a share of whole individuals (individuals) or of "
                      "single error evaluations (evaluations); or individuals one by one, each to an idle slave or to "
                      "the idle master (demand)")),
        deciding("farm",
                 real("own_share", {.by_default = 1, .least = 0, .most = 1},
                      "the master's own share as a fraction of a slave's share; 0: the master evaluates "
                      "nothing; no effect with the split demand, where the master evaluates whenever it is idle")),
        deciding("farm",
                 text("measurements", {.by_default = "sample", .choices = {"sample", "generation"}},
                      "when the slaves are sent the measurements: with each new sample, or in every generation")),
        deciding("farm", integer("tasks_under_way", {.unit = "tasks", .by_default = 1, .least = 1, .most = 1024},
                                 "with the split demand: largest number of unanswered tasks of a slave; with 2, a "
                                 "slave already has its next task when it finishes one")),
        deciding("farm", text("sending", {.by_default = "in turn", .choices = {"in turn", "at once"}},
                              "how the master sends tasks: one after another, or at once by a process for each "
                              "channel, so that all links are busy")),
        deciding("farm", text("results", {.by_default = "chain", .choices = {"chain", "ready"}},
                              "order of the results: chain by chain, each beginning with the farthest slave (chain); "
                              "or each result when it is ready (ready), as always with the split demand")),
        integer("rehearsals", {.unit = "rounds", .by_default = 100, .least = 0, .most = 1e6},
                "rounds of communication without evaluations, which measure C_time2 after the work; the totals of the "
                "work do not include them; 0: C_time2 is not measured"),
    };
}

PortDescription to_slaves() {
    return description::optional(
        description::output<Task>("to_slaves", "task", "to a slave; or an array with one end for each slave"));
}

PortDescription from_slaves() {
    return description::optional(description::input<Fitnesses>(
        "from_slaves", "fitnesses", "from a slave; or an array with one end for each slave"));
}

} // namespace placedpar::search_description
