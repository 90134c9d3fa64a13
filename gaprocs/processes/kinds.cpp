#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/fitness.hpp"
#include "gaprocs/processes/kind_checks.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/settings.hpp"
#include "netlist/catalogue.hpp"
#include "runtime/channel.hpp"

#include <utility>
#include <vector>

namespace placedpar {

namespace {

using Parameters = std::vector<ParameterDescription>;
using Measures = std::vector<MeasureDescription>;

template <class T>
PortDescription port(std::string name, Direction direction, std::string protocol, std::string about,
                     bool optional = false) {
    return {std::move(name), direction,
            optional,        std::move(protocol),
            typeid(T),       [](std::string channel) { return std::make_unique<Channel<T>>(std::move(channel)); },
            std::move(about)};
}

ParameterDescription integer(std::string name, std::string unit, std::int64_t by_default, double least, double most,
                             std::string about) {
    return {std::move(name), ParameterType::integer, std::move(unit), by_default, least, most, {}, std::move(about)};
}

ParameterDescription real(std::string name, std::string unit, double by_default, double least, double most,
                          std::string about) {
    return {std::move(name), ParameterType::real, std::move(unit), by_default, least, most, {}, std::move(about)};
}

ParameterDescription text(std::string name, std::string by_default, std::vector<std::string> choices,
                          std::string about) {
    return {std::move(name),    ParameterType::text, "", std::move(by_default), {}, {},
            std::move(choices), std::move(about)};
}

ParameterDescription problem() {
    return {"problem", ParameterType::text,
            "",        Value{std::string("boom")},
            {},        {},
            {},        "the search problem and its record of measurements"};
}

Parameters operator+(Parameters a, const Parameters& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Of every process that holds a population.
Parameters search_parameters() {
    return {
        problem(),
        integer("population", "individuals", 120, 2, largest_population,
                "size of this process's population (thesis 4.3: 120 in all)"),
        integer("window", "samples", 10, 1, 1024, "samples that the fitness is summed over (eq. 3.9)"),
        integer("first_window", "samples", 5, 1, 1024,
                "samples needed for the first generation; a shorter window must only be full"),
        integer("trials", "generations", 5, 1, 1e6, "generations for each new sample (thesis 4.3)"),
        real("bias", "(unit of the error)^2", 400, 1e-300, fitness_term_limit, "B of the fitness (eq. 3.9)"),
        real("crossover", "", 0.8, 0, 1, "probability that a pair is crossed over"),
        real("mutation", "", 0.01, 0, 1, "probability that a bit is flipped"),
        integer("elite", "individuals", 0, 0, 1e6,
                "best individuals that go over unchanged; evaluated again in every generation (thesis: none)"),
        text("reproduction", "roulette", {"roulette", "universal"},
             "how parents are drawn: by roulette with replacement (thesis), or by stochastic universal sampling"),
        text(
            "coding", "natural", {"natural", "gray"},
            "how a field of the string stands for a number: natural binary (thesis) or Gray code; the slaves are told"),
        text("stream", "", {}, "name of the random stream; the process's own name if empty"),
        integer("cycles_per_error", "cycles", 1440, 0, 1e9, "workload: one individual's error at one sample"),
        integer("cycles_per_individual", "cycles", 1750, 0, 1e9, "workload: the genetic operators, for one individual"),
        integer("cycles_per_measurement_word", "cycles", 0, 0, 1e9,
                "workload: making a word of the measurements ready to send"),
        integer("string_bytes", "bytes", 2, 1, 65536, "an individual's string in a message"),
        integer("fitness_bytes", "bytes", 2, 1, 65536, "an individual's fitness in a message"),
        integer("measurement_bytes", "bytes", 148, 1, 65536, "the measurements of a window in a message (appendix E)"),
    };
}

Parameters farm_parameters() {
    return {
        integer("slaves", "", 1, 1, 4096, "slaves in the chain, where one is connected: as many as there are"),
        text("split", "individuals", {"individuals", "demand", "evaluations"},
             "how the evaluations are dealt out: whole individuals, individuals to whoever is idle, or single error "
             "evaluations"),
        text("measurements", "sample", {"sample", "generation"},
             "when the slaves are sent the measurements: with each new sample, or in every generation"),
        text("results", "chain", {"chain", "ready"},
             "how results come back: in the order of the chain, the farthest first, or as they are ready; on demand "
             "always as they are ready"),
        integer("rehearsals", "rounds", 100, 1, 1e6,
                "rounds of communication with nothing to evaluate, to measure C_time2"),
    };
}

Parameters ring_parameters() {
    return {integer("exchange_every", "generations", 3, 1, 1e6,
                    "how often the islands exchange their best individuals (thesis 4.3)")};
}

Measures search_measures() {
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
    return port<HostMessage>("from_host", Direction::input, "host message", "the samples of the record");
}

std::vector<PortDescription> slave_ports(bool optional) {
    return {
        port<Task>("to_slaves", Direction::output, "task", "to the first slave of the chain", optional),
        port<Fitnesses>("from_slaves", Direction::input, "fitnesses", "from the first slave of the chain", optional)};
}

std::vector<PortDescription> ring_ports() {
    return {port<Emigrant>("ring_out", Direction::output, "emigrant", "to the next island", true),
            port<Emigrant>("ring_in", Direction::input, "emigrant", "from the island before", true)};
}

ProcessKind host_kind() {
    return {
        "ga.host",
        "The host computer's part: sends each sample of the problem's record to every master, as fast as they take it.",
        {port<HostMessage>("to_masters", Direction::output, "host message", "an array: one end for each master")},
        {problem(), integer("samples", "samples", 0, 0, 1e9, "how many samples of the record are sent; 0: all"),
         integer("sample_bytes", "bytes", 16, 1, 65536, "a sample in a message")},
        {},
        {}};
}

ProcessKind traditional_kind() {
    return {"ga.traditional",  "The traditional genetic algorithm: one population, on one processor.",
            {from_host()},     search_parameters(),
            search_measures(), {}};
}

ProcessKind master_kind() {
    ProcessKind kind{
        "ga.master",
        "The master of algorithm A: deals the population out to its slaves, evaluates a share itself, and applies the "
        "genetic operators. Without slaves it is the traditional genetic algorithm.",
        slave_ports(true),
        search_parameters() + farm_parameters(),
        search_measures(),
        {},
        {{"to_slaves", "from_slaves"}}};
    kind.ports.push_back(from_host());
    return kind;
}

ProcessKind slave_kind() {
    return {
        "ga.slave",
        "A slave of algorithm A, one of a chain: evaluates its share and passes on what is for the slaves beyond it.",
        {port<Task>("from_master", Direction::input, "task", "from the master or the slave before"),
         port<Fitnesses>("to_master", Direction::output, "fitnesses", "to the master or the slave before"),
         port<Task>("to_next", Direction::output, "task", "to the slave beyond", true),
         port<Fitnesses>("from_next", Direction::input, "fitnesses", "from the slave beyond", true)},
        {problem(),
         integer("cycles_per_error", "cycles", 1440, 0, 1e9, "workload: one individual's error at one sample"),
         integer("fitness_bytes", "bytes", 2, 1, 65536, "an individual's fitness in a message")},
        {},
        {},
        {{"to_next", "from_next"}}};
}

ProcessKind island_kind() {
    ProcessKind kind{"ga.island",
                     "An island of algorithm B: a genetic algorithm of its own that exchanges its best individual "
                     "around a ring. With "
                     "slaves it is a master as well (A + B); without a ring it is that only.",
                     ring_ports(),
                     search_parameters() + farm_parameters() + ring_parameters(),
                     search_measures(),
                     {},
                     {{"to_slaves", "from_slaves"}, {"ring_out", "ring_in"}}};
    kind.ports.push_back(from_host());
    for (PortDescription& each : slave_ports(true))
        kind.ports.push_back(std::move(each));
    return kind;
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
