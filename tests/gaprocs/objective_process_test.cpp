// Tests that objective problems on the simulated machine have the library's generations, with any number of slaves.

#include "gaprocs/islands.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/usual_settings.hpp"
#include "runtime/fingerprint.hpp"
#include "tests/gaprocs/cluster.hpp"
#include "tests/gaprocs/objectives.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>
#include <vector>

using namespace placedpar;

namespace {

constexpr std::size_t generations = 12;

Cluster sphere_cluster(int slaves, const char* split) {
    return {.slaves = slaves,
            .split = split,
            .measurements = "",
            .problem = "sphere",
            .host_parameters = fmt::format("generations = {}", generations)};
}

std::shared_ptr<const SearchProblem> the_sphere() { return minimise(PlainSphere{}); }

SearchSettings sphere_settings(std::size_t population) {
    SearchSettings settings = usual_settings(*the_sphere());
    settings.population = population;
    return settings;
}

void mix(Fingerprint& populations, const std::vector<Genome>& population) {
    for (const Genome& genome : population)
        for (std::uint64_t word : genome.words())
            populations.mix(word);
}

/// Returns, for each island, the hash of all populations that the island's process measures.
std::vector<std::string> populations_of_library(std::size_t islands, std::vector<RandomStream> streams) {
    auto sphere = the_sphere();
    IslandsSettings settings;
    settings.islands.assign(islands, sphere_settings(30));
    if (islands == 1)
        settings.topology = NoTopology{};
    Islands side_by_side(*sphere, settings, std::move(streams));
    std::vector<Fingerprint> populations(islands);
    for (std::size_t generation = 0; generation < generations; ++generation) {
        side_by_side.push({});
        for (std::size_t i = 0; i < islands; ++i)
            mix(populations[i], side_by_side.searches()[i].population());
        side_by_side.next_generation();
    }
    std::vector<std::string> hashes;
    for (const Fingerprint& hash : populations)
        hashes.push_back(fmt::format("{:016x}", hash.value()));
    return hashes;
}

} // namespace

TEST_CASE("a farm gives an objective problem the library's generations with every split") {
    std::string expected = populations_of_library(1, {RandomStream(1, "one stream")}).front();
    auto result = run_traditional(*the_sphere(), generations, sphere_settings(30), RandomStream(1, "one stream"));
    for (const char* split : {"individuals", "demand", "evaluations"})
        for (int slaves : {0, 1, 2, 7, 29}) {
            CAPTURE(split);
            CAPTURE(slaves);
            RunReport report = run_on_line(sphere_cluster(slaves, split).netlist());
            CHECK(report.result.ending == Ending::completed);
            CHECK(report.measured("master0", "generations") == generations);
            CHECK(report.measured_text("master0", "populations") == expected);
            CHECK(report.measured("master0", "best_objective") == -result.best().best.fitness);
            CHECK(report.measured("master0", "x_3") == result.best().parameters[2]);
        }
}

namespace {

/// Checks that a master with slaves makes the same generations as the library.
void check_farm(const std::string& name, std::shared_ptr<const SearchProblem> problem, SearchSettings settings,
                const std::string& parameters) {
    CAPTURE(name);
    CAPTURE(parameters);
    settings.population = 30;
    Search search(problem->representation(), settings, RandomStream(1, "one stream"));
    Fingerprint populations;
    for (std::size_t generation = 0; generation < generations; ++generation) {
        mix(populations, search.population());
        search.next_generation(evaluate(*problem, search.population(), {}, 400));
    }
    for (const char* split : {"individuals", "demand", "evaluations"}) {
        Cluster cluster = sphere_cluster(3, split);
        cluster.problem = name;
        cluster.master_parameters = "rehearsals = 1" + parameters;
        RunReport report = run_on_line(cluster.netlist());
        CHECK(report.measured_text("master0", "populations") == fmt::format("{:016x}", populations.value()));
    }
}

/// Returns the usual settings with the given crossover and mutation.
SearchSettings settings_with(const SearchProblem& problem, const char* crossover, const char* mutation) {
    SearchSettings settings = usual_settings(problem);
    settings.crossover = Crossover::named(crossover);
    settings.mutation = Mutation::named(mutation);
    return settings;
}

} // namespace

TEST_CASE("a farm gives the library's generations for every representation and coding") {
    for (const char* coding : {"gray", "real", "natural(dont_care = 1)", "gray(3)"}) {
        auto sphere = the_sphere()->coded(Coding::named(coding));
        check_farm("sphere", sphere, usual_settings(*sphere), fmt::format(", coding = \"{}\"", coding));
    }
    for (const auto& [name, problem] : {std::pair{"seats", minimise(Seats{})}, std::pair{"comb", maximise(Comb{})},
                                        std::pair{"plane", minimise(Plane{})}})
        check_farm(name, problem, usual_settings(*problem), "");
}

TEST_CASE("a farm gives the library's generations with every operator that fits") {
    for (const char* crossover : {"one-point", "two-point", "uniform", "blend(alpha = 0.2)", "sbx"})
        for (const char* mutation : {"gaussian(0.3)", "breeder", "polynomial", "uniform"})
            check_farm("plane", minimise(Plane{}), settings_with(*minimise(Plane{}), crossover, mutation),
                       fmt::format(", crossover_operator = \"{}\", mutation_operator = \"{}\"", crossover, mutation));
    for (const char* mutation : {"swap", "inversion"})
        check_farm("seats", minimise(Seats{}), settings_with(*minimise(Seats{}), "order", mutation),
                   fmt::format(", mutation_operator = \"{}\"", mutation));
}

TEST_CASE("a best string that does not code numbers is reported as a text") {
    Cluster cluster = sphere_cluster(0, "individuals");
    cluster.problem = "seats";
    cluster.host_parameters = "generations = 200";
    cluster.master_parameters = "rehearsals = 0, elite = 1";
    RunReport report = run_on_line(cluster.netlist());
    CHECK(report.measured("master0", "best_objective") == 0);
    CHECK(report.measured_text("master0", "best_string") == "0 1 2 3 4 5 6 7 8");
}

TEST_CASE("islands of an objective problem exchange as in the library") {
    Cluster cluster = sphere_cluster(2, "individuals");
    cluster.islands = 3;
    RunReport report = run_on_line(cluster.netlist());
    std::vector<RandomStream> streams;
    for (const char* name : {"master0", "master1", "master2"})
        streams.emplace_back(1, name);
    auto expected = populations_of_library(3, streams);
    for (int i = 0; i < 3; ++i)
        CHECK(report.measured_text(fmt::format("master{}", i), "populations") == expected[static_cast<std::size_t>(i)]);
}

TEST_CASE("a farm with an objective sends no measurements") {
    Cluster cluster = sphere_cluster(1, "individuals");
    RunReport cheap = run_on_line(cluster.netlist());
    Cluster line{.slaves = 1, .master_parameters = "window = 1, trials = 1, rehearsals = 2"};
    RunReport dear = run_on_line(line.netlist());
    // The measurements are 148 bytes of 11 bits at 20 Mbit/s; preparing them takes time, too.
    double difference = dear.measured("master0", "C_time2") - cheap.measured("master0", "C_time2");
    CHECK(difference > 0.08);
    CHECK(difference < 0.2);
}

TEST_CASE(
    "a known optimum is measured beside the best objective, and a result that is not a number is reported in words") {
    Cluster valley = sphere_cluster(0, "individuals");
    valley.problem = "valley(low = -0.5)";
    RunReport report = run_on_line(valley.netlist());
    CHECK(report.measured("master0", "known_optimum") == 0);
    CHECK(report.measured("master0", "best_objective") < 0.1);
    CHECK(report.measured("master0", "along") >= -0.5);
    valley.problem = "nowhere";
    CHECK(run_on_line(valley.netlist()).measured_text("master0", "best_objective") == "not a finite number");
}
