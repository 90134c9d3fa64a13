// Algorithm A must produce exactly the generations of the traditional algorithm, on every machine.

#include "gaprocs/search.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/window.hpp"
#include "runtime/fingerprint.hpp"
#include "tests/gaprocs/cluster.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <set>
#include <string>

using namespace placedpar;

namespace {

SearchSettings settings_for(std::size_t population) {
    SearchSettings settings;
    settings.population = population;
    return settings;
}

/// Returns a hash of all populations of the traditional algorithm in the library.
std::string populations_of_traditional(const SearchSettings& settings, std::uint64_t seed,
                                       Coding coding = Coding::natural) {
    auto problem = make_search_problem(LineProblem{}, coding);
    Search search(problem->bits(), settings, RandomStream(seed, "one stream"));
    SlidingWindow window(settings.window);
    Fingerprint populations;
    for (const Sample& sample : line_record(line_samples)) {
        window.push(sample);
        for (std::size_t trial = 0; window.ready() && trial < settings.window.trials; ++trial) {
            for (const Genome& genome : search.population())
                for (std::uint64_t word : genome.words())
                    populations.mix(word);
            search.next_generation(evaluate(*problem, search.population(), window.samples(), settings.window.bias));
        }
    }
    return fmt::format("{:016x}", populations.value());
}

std::string populations_of_traditional(std::size_t population, std::uint64_t seed) {
    return populations_of_traditional(settings_for(population), seed);
}

} // namespace

TEST_CASE("algorithm A has the traditional generations with 0 to 29 slaves and every split") {
    std::string traditional = populations_of_traditional(30, 1);
    test::EveryNth sampled(29);
    for (const char* split : {"individuals", "demand", "evaluations"})
        for (int slaves = 0; slaves <= 29; ++slaves) {
            if (sampled.passes_over())
                continue;
            CAPTURE(split);
            CAPTURE(slaves);
            RunReport report = run_on_line(Cluster{.slaves = slaves, .split = split}.netlist());
            CHECK(report.result.ending == Ending::completed);
            CHECK(report.measured_text("master0", "populations") == traditional);
        }
}

TEST_CASE("algorithm A has the traditional generations at every speed of processors and links") {
    std::string traditional = populations_of_traditional(30, 1);
    Cluster slow_neighbours{
        .slaves = 5, .split = "demand", .even_processor = "clock = 20M", .odd_processor = "clock = 5M"};
    Cluster slow_master{.slaves = 4, .even_processor = "clock = 3M, channelcall = 500"};
    Cluster slow_links{.slaves = 4,
                       .even_processor = "linkspeed = 5M",
                       .odd_processor = "linkspeed = 5M",
                       .workstation = "linkspeed = 5M"};
    Cluster no_work{.slaves = 3,
                    .master_parameters = "rehearsals = 1, cycles_per_error = 0, cycles_per_individual = 0"};
    Cluster every_generation{.slaves = 3, .measurements = "generation"};
    for (const Cluster& cluster : {slow_neighbours, slow_master, slow_links, no_work, every_generation})
        CHECK(run_on_line(cluster.netlist()).measured_text("master0", "populations") == traditional);
}

TEST_CASE("algorithm A has the traditional generations with an elite, Gray code and universal sampling") {
    std::set<std::string> different{populations_of_traditional(30, 1)};
    test::EveryNth sampled(13);
    for (std::size_t elite : {0u, 3u})
        for (Coding coding : {Coding::natural, Coding::gray})
            for (bool universal : {false, true}) {
                SearchSettings settings = settings_for(30);
                settings.elite = elite;
                settings.reproduction = universal ? Reproduction(UniversalReproduction{}) : Reproduction();
                std::string traditional = populations_of_traditional(settings, 1, coding);
                different.insert(traditional);
                std::string parameters =
                    fmt::format("rehearsals = 1, elite = {}, coding = \"{}\", reproduction = \"{}\"", elite,
                                coding.text(), universal ? "universal" : "roulette");
                CAPTURE(parameters);
                for (const char* split : {"individuals", "demand", "evaluations"})
                    for (int slaves : {0, 1, 4}) {
                        if (sampled.passes_over())
                            continue;
                        CAPTURE(split);
                        CAPTURE(slaves);
                        Cluster cluster{.slaves = slaves, .split = split, .master_parameters = parameters};
                        CHECK(run_on_line(cluster.netlist()).measured_text("master0", "populations") == traditional);
                    }
            }
    CHECK(different.size() == 8); // every option has an effect
}

TEST_CASE("algorithm A has the traditional generations with every reproduction and crossover") {
    std::set<std::string> different;
    test::EveryNth sampled(7);
    for (const char* reproduction : {"roulette", "universal", "scaled(1.5)", "ranking", "tournament(3)"})
        for (const char* crossover : {"one-point", "two-point", "uniform", "by-difference"}) {
            SearchSettings settings = settings_for(30);
            settings.reproduction = Reproduction::named(reproduction);
            settings.crossover = Crossover::named(crossover);
            std::string traditional = populations_of_traditional(settings, 1, Coding::natural);
            different.insert(traditional);
            auto parameters = fmt::format("rehearsals = 1, reproduction = \"{}\", crossover_operator = \"{}\"",
                                          reproduction, crossover);
            CAPTURE(parameters);
            Cluster cluster{.slaves = 3, .master_parameters = parameters};
            if (sampled.passes_over())
                continue;
            CHECK(run_on_line(cluster.netlist()).measured_text("master0", "populations") == traditional);
        }
    CHECK(different.size() == 20);
}

TEST_CASE("the netlist's checker refuses a policy with a number out of range, and states the range") {
    Cluster cluster{.master_parameters = "rehearsals = 1, reproduction = \"tournament(0)\""};
    CHECK_THROWS_WITH_AS(run_on_line(cluster.netlist()), doctest::Contains("a whole number from 1 to 1000000"),
                         std::runtime_error);
}

TEST_CASE("an elite as large as the population is refused, and the message states the largest elite") {
    Cluster cluster{.master_parameters = "rehearsals = 1, elite = 30"};
    CHECK_THROWS_WITH_AS(run_on_line(cluster.netlist()), doctest::Contains("the greatest possible elite is 28"),
                         std::runtime_error);
}

TEST_CASE("the netlist's checker refuses an unknown coding and suggests one") {
    Cluster cluster{.master_parameters = "rehearsals = 1, coding = \"grey\""};
    CHECK_THROWS_WITH_AS(run_on_line(cluster.netlist()), doctest::Contains("gray"), std::runtime_error);
}

TEST_CASE("algorithm A has other generations with another seed") {
    Cluster cluster{.slaves = 2};
    std::string second = run_on_line(cluster.netlist(), 2).measured_text("master0", "populations");
    CHECK(second == populations_of_traditional(30, 2));
    CHECK(second != populations_of_traditional(30, 1));
}

TEST_CASE("a generation with three slaves is more than 2.5 times as fast as without slaves") {
    double alone = run_on_line(Cluster{}.netlist()).measured("master0", "T_exe");
    double with_three = run_on_line(Cluster{.slaves = 3}.netlist()).measured("master0", "T_exe");
    CHECK(with_three < alone / 2.5);
    RunReport report = run_on_line(Cluster{.slaves = 3}.netlist());
    REQUIRE(report.processors.size() == 4);
    for (const ProcessorUse& processor : report.processors)
        CHECK(report.share(processor.busy) > 0.5);
}

TEST_CASE("more slaves than individuals are refused, and the message states the largest number of slaves") {
    CHECK_THROWS_WITH_AS(run_on_line(Cluster{.slaves = 30}.netlist()), doctest::Contains("at most 29 slaves"),
                         std::runtime_error);
}

TEST_CASE("a window longer than the record is refused before the run") {
    Cluster cluster{.master_parameters = "rehearsals = 1, window = 13"};
    CHECK_THROWS_WITH_AS(run_on_line(cluster.netlist()), doctest::Contains("window"), std::runtime_error);
}
