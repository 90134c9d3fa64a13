#include "explore/generate/job.hpp"

#include "explore/generate/statements.hpp"
#include "gaprocs/problem_registry.hpp"
#include "netlist/print/text.hpp"

#include <fmt/format.h>

namespace placedpar::generate {

namespace {

/// The computing costs of examples/thesis/workload.inc, which assumes that Table E.1 was measured with a population of
/// 120.
constexpr const char* workload =
    R"(val cycles_per_error 1440;      /* Table E.1: one individual's error at one sample */
val cycles_per_individual 1750; /* the genetic operators, for one individual */
)";

/// Returns the parameters that both masters and islands have.
std::string costs(const ProblemStatements& problem) {
    return "population = population, cycles_per_error = cycles_per_error,\n"
           "        cycles_per_individual = cycles_per_individual, " +
           problem.search;
}

std::string host_process(const ProblemStatements& problem) {
    return fmt::format("process host;\nuse \"ga.host\" for host;\nhost ({});\n", problem.host);
}

/// Returns the parameters for the generations per sample and the bias that suit the problem's measurements.
std::string advised(const RecordAdvice& advice) {
    std::string text = advice.trials == 0 ? "" : fmt::format(", trials = {}", advice.trials);
    return advice.bias == 0 ? text : text + fmt::format(", bias = {:g}", advice.bias);
}

const std::vector<std::string> each_processor{"rep i = 0 for nodes"};

std::string use(const char* kind, const char* process) { return fmt::format("use \"{}\" for {};\n", kind, process); }

/// Returns statements that declare the constants (`val`) by which a population of 120 is divided among islands. An
/// island has at least `least` individuals. `least` must be at least 4, for the immigrants that can arrive together
/// from four neighbours, and greater than the island's number of slaves.
std::string population_of(const char* islands, const char* least) {
    return fmt::format("val population 120 / {0} > {1} ? 120 / {0} : {1}; /* of each island */\n"
                       "val exchange_every 3;           /* generations between exchanges */\n",
                       islands, least);
}

/// Returns the parameters of a slave.
std::string of_slave(const ProblemStatements& problem) {
    return "cycles_per_error = cycles_per_error" + (problem.each.empty() ? "" : ", " + problem.each);
}

} // namespace

ProblemStatements statements_of(const std::string& name, const RecordedProblem* problem) {
    const std::string samples = "val samples 0;                  /* of the record; 0: all */\n";
    if (!problem)
        return {samples, "samples = samples", "cycles_per_measurement_word = 134, string_bytes = 2", ""};
    const std::string named = fmt::format("val problem {};\n", print_constant(name)), each = "problem = problem";
    if (problem->problem()->objective())
        return {named + "val generations 100;\n", each + ", generations = generations", each, each};
    return {named + samples, each + ", samples = samples", each + advised(problem->advice()), each};
}

Job farm(const Topology& topology, const ProblemStatements& problem) {
    std::string statements = host_process(problem);
    statements += "process master;\n" + use("ga.master", "master");
    statements += fmt::format("master ({});\n", costs(problem));
    statements += "connect host.to_masters[0] to master.from_host;\n";
    statements += fmt::format("place master on t{};\n", topology.first);
    statements +=
        "if nodes > 1 {\n    process slave[nodes - 1];\n    use \"ga.slave\" for slave;\n"
        "    master (slaves = nodes - 1);\n    slave (" +
        of_slave(problem) +
        ");\n    rep i = 1 for nodes - 1 {\n        connect master.to_slaves[i - 1] to slave[i - 1].from_master;\n"
        "        connect slave[i - 1].to_master to master.from_slaves[i - 1];\n";
    statements += fmt::format("        place slave[i - 1] on t{};\n    }}\n}}\n", topology.at);
    return {.has_host = true,
            .about = "A farm: a master on the first processor, slaves on all others. Messages to distant slaves "
                     "pass through other processors.",
            .vals = "val population nodes > 120 ? nodes : 120;\n" + problem.vals + workload,
            .statements = statements};
}

Job islands(const Topology& topology, const ProblemStatements& problem) {
    std::string statements = host_process(problem);
    statements += fmt::format("process island{};\n", topology.array) + use("ga.island", "island");
    statements += fmt::format("island ({});\n", costs(problem));
    statements += "if nodes > 1\n    island (exchange_every = exchange_every);\n";
    statements += within(each_processor, {fmt::format("connect host.to_masters[i] to island{}.from_host;", topology.at),
                                          fmt::format("place island{0} on t{0};", topology.at)});
    statements += print_channels(topology, "island", "to_neighbours", "from_neighbours");
    return {.has_host = true,
            .about = "Islands: one on every processor. Neighbours exchange individuals.",
            .vals = problem.vals + workload + population_of("nodes", "4"),
            .statements = statements};
}

Job islands_with_slaves(const ProblemStatements& problem) {
    std::string statements = host_process(problem);
    statements += "process island[clusters];\n" + use("ga.island", "island");
    statements += fmt::format("island ({});\n", costs(problem));
    statements += "rep c = 0 for clusters {\n"
                  "    connect host.to_masters[c] to island[c].from_host;\n"
                  "    place island[c] on t[c][0];\n"
                  "    if clusters > 1 {\n"
                  "        island[c] (exchange_every = exchange_every);\n"
                  "        connect island[c].to_neighbours[0] to island[(c + 1) % clusters].from_neighbours[0];\n"
                  "    }\n"
                  "}\n"
                  "if slaves > 0 {\n"
                  "    process slave[clusters][slaves];\n"
                  "    use \"ga.slave\" for slave;\n"
                  "    slave (" +
                  of_slave(problem) +
                  ");\n"
                  "    island (slaves = slaves);\n"
                  "    rep c = 0 for clusters {\n"
                  "        connect island[c].to_slaves to slave[c][0].from_master;\n"
                  "        connect slave[c][0].to_master to island[c].from_slaves;\n"
                  "        rep i = 0 for slaves\n"
                  "            place slave[c][i] on t[c][i + 1];\n"
                  "        rep i = 0 for slaves - 1 {\n"
                  "            connect slave[c][i].to_slaves to slave[c][i + 1].from_master;\n"
                  "            connect slave[c][i + 1].to_master to slave[c][i].from_slaves;\n"
                  "        }\n"
                  "    }\n"
                  "}\n";
    return {.has_host = true,
            .about = "Islands: one at the head of each chain, with slaves along the chain. Each island sends "
                     "individuals to the next island of the ring.",
            .vals = problem.vals + workload + population_of("clusters", "slaves + 4"),
            .statements = statements};
}

Job processes_of(const std::string& kind, bool has_host, const std::string& output, const std::string& input,
                 const Topology& topology, const ProblemStatements& problem, const std::string& parameters) {
    std::string statements = has_host ? host_process(problem) : "";
    statements += fmt::format("process node{};\n", topology.array) + use(kind.c_str(), "node");
    if (!parameters.empty())
        statements += fmt::format("node ({});\n", parameters);
    std::vector<std::string> of_each{fmt::format("place node{0} on t{0};", topology.at)};
    if (has_host)
        of_each.push_back(fmt::format("connect host.to_masters[i] to node{}.from_host;", topology.at));
    statements += within(each_processor, of_each);
    statements += print_channels(topology, "node", output, input);
    return {.has_host = has_host,
            .about = fmt::format("A {} on every processor, connected with its neighbours.", kind),
            .vals = has_host ? problem.vals : "",
            .statements = statements};
}

} // namespace placedpar::generate
