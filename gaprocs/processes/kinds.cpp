#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/fitness.hpp"
#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/settings.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/kinds/description.hpp"

#include <utility>
#include <vector>

namespace placedpar {

namespace {

using Parameters = std::vector<ParameterDescription>;
using Measurements = std::vector<MeasurementDescription>;

ParameterDescription problem() {
    return description::text("problem", {.by_default = "boom"}, "the search problem and its record of measurements");
}

Parameters operator+(Parameters a, const Parameters& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

Parameters population_parameters() {
    using namespace description;
    return {
        problem(),
        integer("population", {.unit = "individuals", .by_default = 120, .least = 2, .most = largest_population},
                "size of this process's population (thesis 4.3: 120 in all)"),
        integer("window", {.unit = "samples", .by_default = 10, .least = 1, .most = 1024},
                "samples that the fitness is summed over (eq. 3.9)"),
        integer("first_window", {.unit = "samples", .by_default = 5, .least = 1, .most = 1024},
                "samples needed for the first generation; a shorter window must only be full"),
        integer("trials", {.unit = "generations", .by_default = 5, .least = 1, .most = 1e6},
                "generations for each new sample (thesis 4.3)"),
    };
}

Parameters operator_parameters() {
    using namespace description;
    return {
        real("bias", {.unit = "(unit of the error)^2", .by_default = 400, .least = 1e-300, .most = fitness_term_limit},
             "B of the fitness (eq. 3.9)"),
        real("crossover", {.by_default = 0.8, .least = 0, .most = 1}, "probability that a pair is crossed over"),
        real("mutation", {.by_default = 0.01, .least = 0, .most = 1}, "probability that a bit is flipped"),
        integer("elite", {.unit = "individuals", .by_default = 0, .least = 0, .most = 1e6},
                "best individuals that go over unchanged; evaluated again in every generation (thesis: none)"),
        text("reproduction", {.by_default = "roulette", .choices = {"roulette", "universal"}},
             "how parents are drawn: by roulette with replacement (thesis), or by stochastic universal sampling"),
        text("coding", {.by_default = "natural", .choices = {"natural", "gray"}},
             "how a field of the string stands for a number: natural binary (thesis) or Gray code; the slaves are "
             "told"),
        text("stream", {.by_default = ""}, "name of the random stream; the process's own name if empty"),
    };
}

ParameterDescription cycles_per_error() {
    return description::integer("cycles_per_error", {.unit = "cycles", .by_default = 1440, .least = 0, .most = 1e9},
                                "workload: one individual's error at one sample");
}

Parameters workload_parameters() {
    using namespace description;
    return {
        cycles_per_error(),
        integer("cycles_per_individual", {.unit = "cycles", .by_default = 1750, .least = 0, .most = 1e9},
                "workload: the genetic operators, for one individual"),
        integer("cycles_per_measurement_word", {.unit = "cycles", .by_default = 0, .least = 0, .most = 1e9},
                "workload: making a word of the measurements ready to send"),
    };
}

ParameterDescription message_bytes(std::string name, std::int64_t by_default, std::string about) {
    return description::integer(std::move(name), {.unit = "bytes", .by_default = by_default, .least = 1, .most = 65536},
                                std::move(about));
}

ParameterDescription fitness_bytes() {
    return message_bytes("fitness_bytes", 2, "an individual's fitness in a message");
}

/// Of every process that holds a population.
Parameters search_parameters() {
    return population_parameters() + operator_parameters() + workload_parameters() +
           Parameters{
               message_bytes("string_bytes", 2, "an individual's string in a message"), fitness_bytes(),
               message_bytes("measurement_bytes", 148, "the measurements of a window in a message (appendix E)")};
}

Parameters farm_parameters() {
    using namespace description;
    return {
        integer("slaves", {.by_default = 1, .least = 1, .most = 4096},
                "slaves in the chain, where one is connected: as many as there are"),
        text("split", {.by_default = "individuals", .choices = {"individuals", "demand", "evaluations"}},
             "how the evaluations are dealt out: whole individuals, individuals to whoever is idle, or single error "
             "evaluations"),
        text("measurements", {.by_default = "sample", .choices = {"sample", "generation"}},
             "when the slaves are sent the measurements: with each new sample, or in every generation"),
        text("results", {.by_default = "chain", .choices = {"chain", "ready"}},
             "how results come back: in the order of the chain, the farthest first, or as they are ready; on demand "
             "always as they are ready"),
        integer("rehearsals", {.unit = "rounds", .by_default = 100, .least = 1, .most = 1e6},
                "rounds of communication with nothing to evaluate, to measure C_time2"),
    };
}

Parameters ring_parameters() {
    return {description::integer("exchange_every", {.unit = "generations", .by_default = 3, .least = 1, .most = 1e6},
                                 "how often the islands exchange their best individuals (thesis 4.3)")};
}

Measurements search_measurements() {
    return {
        {"T_exe", "ms", "one generation; like all times a mean over those with a full window, not there without one"},
        {"T_sr", "ms", "from the first send to the last receive"},
        {"P_time2", "ms", "the process's own share of the error evaluations"},
        {"C_time2", "ms", "the communication of a generation with new measurements and nothing to evaluate"},
        {"S_time2", "ms", "the genetic operators"},
        {"generations", "", "generations evaluated"},
        {"generations_per_second", "1/s",
         "with everything that a generation and a new sample cost; not there when they cost no time"},
        {"populations", "", "a hash of every population, in order: equal for equal generations"},
        {"best_fitness", "(unit of the error)^2", "of the last generation's best individual"},
        {"the problem's parameters", "", "as decoded from that individual"},
    };
}

PortDescription from_host() {
    return description::input<HostMessage>("from_host", "host message", "the samples of the record");
}

PortDescription to_slaves() {
    return description::optional(description::output<Task>("to_slaves", "task", "to the first slave of the chain"));
}

PortDescription from_slaves() {
    return description::optional(
        description::input<Fitnesses>("from_slaves", "fitnesses", "from the first slave of the chain"));
}

PortDescription ring_out() {
    return description::optional(description::output<Emigrant>("ring_out", "emigrant", "to the next island"));
}

PortDescription ring_in() {
    return description::optional(description::input<Emigrant>("ring_in", "emigrant", "from the island before"));
}

ProcessKind host_kind() {
    using namespace description;
    return {.name = "ga.host",
            .about = "The host computer's part: sends each sample of the problem's record to every master, as fast as "
                     "they take it.",
            .ports = {output<HostMessage>("to_masters", "host message", "an array: one end for each master")},
            .parameters = {problem(),
                           integer("samples", {.unit = "samples", .by_default = 0, .least = 0, .most = 1e9},
                                   "how many samples of the record are sent; 0: all"),
                           message_bytes("sample_bytes", 16, "a sample in a message")}};
}

ProcessKind traditional_kind() {
    return {.name = "ga.traditional",
            .about = "The traditional genetic algorithm: one population, on one processor.",
            .ports = {from_host()},
            .parameters = search_parameters(),
            .measurements = search_measurements()};
}

ProcessKind master_kind() {
    return {.name = "ga.master",
            .about = "The master of algorithm A: deals the population out to its slaves, evaluates a share itself, and "
                     "applies the genetic operators. Without slaves it is the traditional genetic algorithm.",
            .ports = {to_slaves(), from_slaves(), from_host()},
            .parameters = search_parameters() + farm_parameters(),
            .measurements = search_measurements(),
            .together = {{"to_slaves", "from_slaves"}}};
}

ProcessKind slave_kind() {
    using namespace description;
    return {.name = "ga.slave",
            .about = "A slave of algorithm A, one of a chain: evaluates its share and passes on what is for the slaves "
                     "beyond it.",
            .ports = {input<Task>("from_master", "task", "from the master or the slave before"),
                      output<Fitnesses>("to_master", "fitnesses", "to the master or the slave before"),
                      optional(output<Task>("to_next", "task", "to the slave beyond")),
                      optional(input<Fitnesses>("from_next", "fitnesses", "from the slave beyond"))},
            .parameters = {problem(), cycles_per_error(), fitness_bytes()},
            .together = {{"to_next", "from_next"}}};
}

ProcessKind island_kind() {
    return {.name = "ga.island",
            .about = "An island of algorithm B: a genetic algorithm of its own that exchanges its best individual "
                     "around a ring. With slaves it is a master as well (A + B); without a ring it is that only.",
            .ports = {ring_out(), ring_in(), from_host(), to_slaves(), from_slaves()},
            .parameters = search_parameters() + farm_parameters() + ring_parameters(),
            .measurements = search_measurements(),
            .together = {{"to_slaves", "from_slaves"}, {"ring_out", "ring_in"}}};
}

} // namespace

void add_genetic_algorithm_kinds(Catalogue& catalogue, const ProblemRegistry& problems) {
    using Body = void(ProcessEnvironment&, const ProblemRegistry&);
    using Check = std::vector<Complaint>(const Network&, std::size_t, const ProblemRegistry&);
    auto add = [&](ProcessKind kind, Body* body, Check* check) {
        kind.body = [&problems, body](ProcessEnvironment& environment) { body(environment, problems); };
        kind.check = [&problems, check](const Network& network, std::size_t process) {
            return check(network, process, problems);
        };
        catalogue.add(std::move(kind));
    };
    add(host_kind(), run_host, check_host);
    add(traditional_kind(), run_search, check_search);
    add(master_kind(), run_search, check_search);
    add(slave_kind(), run_slave, check_slave);
    add(island_kind(), run_search, check_search);
}

} // namespace placedpar
