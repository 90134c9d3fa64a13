// Algorithm B on the simulated machine against the islands of the library.

#include "gaprocs/islands.hpp"
#include "runtime/fingerprint.hpp"
#include "tests/gaprocs/cluster.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace placedpar;

namespace {

/// A hash of every population of each island, as processes measure it, with the policies by default: every third
/// generation the best of each replaces the worst of the next.
std::vector<std::string> populations_of_ring(std::size_t islands, std::size_t population) {
    auto problem = make_search_problem(LineProblem{});
    SearchSettings each;
    each.population = population;
    std::vector<RandomStream> streams;
    for (std::size_t i = 0; i < islands; ++i)
        streams.emplace_back(1, fmt::format("master{}", i));
    IslandsSettings settings;
    settings.islands.assign(islands, each);
    Islands side_by_side(*problem, settings, streams);
    std::vector<Fingerprint> populations(islands);
    for (const Sample& sample : line_record(line_samples)) {
        side_by_side.push(sample);
        for (std::size_t trial = 0; side_by_side.ready() && trial < each.window.trials; ++trial) {
            for (std::size_t i = 0; i < islands; ++i)
                for (const Genome& genome : side_by_side.searches()[i].population())
                    for (std::uint64_t word : genome.words())
                        populations[i].mix(word);
            side_by_side.next_generation();
        }
    }
    std::vector<std::string> hashes;
    for (const Fingerprint& hash : populations)
        hashes.push_back(fmt::format("{:016x}", hash.value()));
    return hashes;
}

void check_ring(const Cluster& cluster) {
    RunReport report = run_on_line(cluster.netlist());
    CHECK(report.result.ending == Ending::completed);
    auto expected =
        populations_of_ring(static_cast<std::size_t>(cluster.islands), static_cast<std::size_t>(cluster.population));
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
