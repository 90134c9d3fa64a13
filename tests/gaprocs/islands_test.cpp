// Algorithm B on the simulated machine against islands stepped by hand.

#include "gaprocs/search.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/window.hpp"
#include "runtime/fingerprint.hpp"
#include "tests/gaprocs/cluster.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace placedpar;

namespace {

/// Islands in a ring, all in step: every third generation the best of each replaces the worst of the next.
std::vector<std::string> populations_of_ring(int islands, int population) {
    SearchSettings settings;
    settings.population = static_cast<std::size_t>(population);
    auto problem = make_search_problem(LineProblem{});
    std::vector<Search> searches;
    std::vector<Fingerprint> populations(static_cast<std::size_t>(islands));
    for (int i = 0; i < islands; ++i)
        searches.emplace_back(problem->bits(), settings, RandomStream(1, fmt::format("master{}", i)));
    SlidingWindow window(settings.window);
    int generation = 0;
    for (const Sample& sample : line_record(line_samples)) {
        window.push(sample);
        for (std::size_t trial = 0; window.ready() && trial < settings.window.trials; ++trial) {
            std::vector<std::vector<double>> fitness;
            std::vector<Individual> emigrants;
            for (std::size_t i = 0; i < searches.size(); ++i) {
                for (const Genome& genome : searches[i].population())
                    for (std::uint64_t word : genome.words())
                        populations[i].mix(word);
                fitness.push_back(evaluate(*problem, searches[i].population(), window.samples(), settings.window.bias));
                emigrants.push_back(searches[i].emigrant(fitness.back()));
            }
            ++generation;
            for (std::size_t i = 0; i < searches.size(); ++i) {
                if (generation % 3 == 0)
                    searches[(i + 1) % searches.size()].accept(emigrants[i], fitness[(i + 1) % searches.size()]);
            }
            for (std::size_t i = 0; i < searches.size(); ++i)
                searches[i].next_generation(fitness[i]);
        }
    }
    std::vector<std::string> hashes;
    for (const Fingerprint& each : populations)
        hashes.push_back(fmt::format("{:016x}", each.value()));
    return hashes;
}

void check_ring(const Cluster& cluster) {
    RunReport report = run_on_line(cluster.netlist());
    CHECK(report.result.ending == Ending::completed);
    auto expected = populations_of_ring(cluster.islands, cluster.population);
    for (int i = 0; i < cluster.islands; ++i)
        CHECK(report.measured_text(fmt::format("master{}", i), "populations") == expected[static_cast<std::size_t>(i)]);
}

} // namespace

TEST_CASE("islands in a ring exchange their bests every third generation") {
    check_ring({.islands = 2, .population = 10});
    check_ring({.islands = 4, .population = 30});
}

TEST_CASE("islands that are masters do the same") {
    check_ring({.slaves = 3, .islands = 4, .population = 30});
    check_ring({.slaves = 2, .islands = 3, .population = 9, .split = "evaluations"});
}

TEST_CASE("without exchange the islands are other searches") {
    Cluster exchanging{.islands = 2, .population = 10};
    Cluster rarely{.islands = 2, .population = 10, .master_parameters = "rehearsals = 1, exchange_every = 1000"};
    CHECK(run_on_line(exchanging.netlist()).measured_text("master0", "populations") !=
          run_on_line(rarely.netlist()).measured_text("master0", "populations"));
}
