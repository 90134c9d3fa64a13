// Runs random combinations of policies on every known problem: with the library alone, and as processes on machines
// with every placement and speed.

#include "explore/netlist_run.hpp"
#include "explore/problems.hpp"
#include "explore/study/measure.hpp"
#include "gaprocs/policies/coding.hpp"
#include "gaprocs/spread_population.hpp"
#include "gaprocs/usual_settings.hpp"
#include "tests/gaprocs/island_netlist.hpp"
#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

using namespace placedpar;
using test::IslandNetlist;
using test::LibraryRun;

namespace {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : random_(seed, "combination") {}
    std::size_t between(std::size_t least, std::size_t most) {
        return least + random_.below(static_cast<std::uint32_t>(most - least + 1));
    }
    template <class T>
    T one_of(std::initializer_list<T> all) {
        return *(all.begin() + between(0, all.size() - 1));
    }

private:
    RandomStream random_;
};

/// The islands of a search, and the parts of their netlists that are not settings.
struct Combination {
    std::string problem;
    std::string coding, reproduction, crossover, mutation; ///< "": the problem's usual policy
    std::string initial = "random";
    IslandsSettings settings;
};

void draw_operators(Combination& all, Dice& dice) {
    std::string kind = dice.one_of<const char*>({"strings", "numbers", "record", "reals", "tours"});
    if (kind == "tours")
        all.problem = dice.one_of<const char*>({"tour-circle(cities = 9)", "tour-lattice(rows = 3, columns = 4)"});
    else if (kind == "strings")
        all.problem =
            dice.one_of<const char*>({"one-max(bits = 40)", "trap(blocks = 4, size = 4)", "nk(bits = 20, k = 3)"});
    else if (kind == "record")
        all.problem = dice.one_of<const char*>({"boom", "plant(noise = 0.3)", "plant(simulated = 1, per_sample = 5)"});
    else
        all.problem =
            dice.one_of<const char*>({"sphere", "rastrigin(dimensions = 4)", "schwefel(dimensions = 3)", "griewank",
                                      "rosenbrock", "step", "quartic(dimensions = 5)", "foxholes"});
    bool coded = kind == "record" || kind == "numbers";
    all.coding = kind == "reals" ? "real"
                 : coded
                     ? dice.one_of<const char*>({"natural", "gray", "gray(dont_care = 1)", "natural(dont_care = 2)"})
                     : "natural";
    all.crossover = kind == "reals"   ? dice.one_of<const char*>({"", "blend", "blend(alpha = 0.2)", "two-point"})
                    : kind == "tours" ? dice.one_of<const char*>({"", "order"})
                                      : dice.one_of<const char*>({"", "two-point", "uniform", "by-difference"});
    all.mutation = kind == "reals"   ? dice.one_of<const char*>({"", "gaussian(0.3)", "breeder", "uniform"})
                   : kind == "tours" ? dice.one_of<const char*>({"", "inversion", "swap"})
                                     : dice.one_of<const char*>({"", "bit", "distance"});
    all.reproduction = dice.one_of<const char*>({"", "scaled(1.5)", "ranking", "ranking(1.3)", "tournament(4)"});
    if (kind == "record" && dice.one_of({false, true})) // fitness that may be positive
        all.reproduction = dice.one_of<const char*>({"roulette", "universal"});
    if (coded)
        all.initial = dice.one_of<const char*>({"random", "spread"});
}

/// Draws the island's initial strings as the process of this number draws them.
void spread(SearchSettings& island, std::size_t number, const SearchProblem& problem, std::uint64_t seed) {
    RandomStream random(seed, fmt::format("island[{}] spread", number));
    island.initial = spread_population(island.population, problem, random);
}

void draw_islands(Combination& all, const SearchProblem& problem, std::uint64_t seed, Dice& dice) {
    SearchSettings each = usual_settings(problem);
    if (!all.reproduction.empty())
        each.reproduction = Reproduction::named(all.reproduction);
    if (!all.crossover.empty())
        each.crossover = Crossover::named(all.crossover);
    if (!all.mutation.empty())
        each.mutation = Mutation::named(all.mutation);
    each.crossover_probability = dice.one_of({0.0, 0.5, 0.75, 1.0});
    each.mutation_probability = dice.one_of({0.0, 0.015625, 0.125, 1.0});
    each.elite = dice.between(0, 2);
    if (!problem.objective())
        each.window = {5, 3, dice.between(1, 3), dice.one_of({10.0, 400.0})};
    std::string topology = dice.one_of<const char*>({"ring", "ring(2)", "hypercube", "torus", "star", "complete"});
    std::size_t islands = topology == "hypercube" ? dice.one_of<std::size_t>({2, 4, 8})
                          : topology == "torus"   ? dice.one_of<std::size_t>({4, 6})
                                                  : dice.between(2, 6);
    for (std::size_t i = 0; i < islands; ++i) {
        each.population = dice.between(22, 30);
        if (!problem.objective())
            each.window.length = dice.between(3, 10);
        if (all.initial == "spread")
            spread(each, i, problem, seed);
        all.settings.islands.push_back(each);
    }
    all.settings.topology = Topology::named(topology);
    all.settings.schedule =
        Schedule::named(dice.one_of<const char*>({"broadcast(1)", "broadcast(3)", "sequential(2)"}));
    all.settings.emigration =
        Emigration::named(dice.one_of<const char*>({"best", "best(2)", "random(2)", "tournament(2, 3)"}));
    all.settings.acceptance = Acceptance::named(
        dice.one_of<const char*>({"worst", "worst(1)", "random", "random(1)", "alike", "alike(1)", "offspring"}));
}

std::string island_parameters(const Combination& all) {
    const SearchSettings& each = all.settings.islands.front();
    std::string text = fmt::format(", coding = \"{}\", initial = \"{}\", crossover = {:.6f}, mutation = {:.6f}",
                                   all.coding, all.initial, each.crossover_probability, each.mutation_probability);
    for (auto [parameter, entry] :
         {std::pair("reproduction", &all.reproduction), std::pair("crossover_operator", &all.crossover),
          std::pair("mutation_operator", &all.mutation)})
        if (!entry->empty())
            text += fmt::format(", {} = \"{}\"", parameter, *entry);
    return text;
}

IslandNetlist netlist_of(const Combination& all, bool recorded, Dice& dice) {
    IslandNetlist netlist{all.settings};
    netlist.problem = all.problem;
    netlist.host = recorded ? ", samples = 12" : ", generations = 6";
    netlist.recorded = recorded;
    netlist.more = island_parameters(all);
    netlist.transputer = dice.one_of<const char*>({"clock = 15M", "clock = 20M", "clock = 30M"});
    netlist.other_transputer = dice.one_of<const char*>({"clock = 17M", "clock = 25M"});
    return netlist;
}

/// Returns machines that differ only in properties that must not change the search.
std::vector<IslandNetlist> machines(IslandNetlist netlist, Dice& dice) {
    using On = IslandNetlist::On;
    std::vector<IslandNetlist> all;
    for (On on : {On::one_transputer, On::four_transputers, On::workstations}) {
        netlist.on = on;
        netlist.wire = dice.one_of<const char*>({"linkspeed = 5M", "linkspeed = 20M"});
        all.push_back(netlist);
    }
    netlist.slaves = static_cast<int>(dice.between(1, 3));
    netlist.more +=
        dice.one_of<const char*>({", split = \"individuals\"", ", split = \"demand\", tasks_under_way = 2"});
    all.push_back(netlist);
    return all;
}

struct Counts {
    std::size_t repeated = 0, departed = 0;
};

std::string all_figures(const RunReport& report, const Network& network) {
    return fmt::format("{} {:016x} {} {}", name_of(report.result.ending), report.result.fingerprint,
                       to_string(report.result.time), figures_text(figures_of(report, network)));
}

/// Checks that a worker's repetition of a run with another seed reports the same as a separate run with that seed.
void check_repeated(const Network& network, std::uint64_t seed, const RunReport& report, Counts& counts) {
    ProblemRegistry problems = known_problems(seed), of_another = known_problems(seed + 1);
    Catalogue kinds = known_kinds(problems), kinds_of_another = known_kinds(of_another);
    if (!is_determinate(network, kinds))
        return;
    RecordedRun record;
    RunReport recorded = run_netlist(network, kinds, {.seed = seed, .record = &record});
    CHECK(all_figures(recorded, network) == all_figures(report, network));
    REQUIRE(record.can_be_repeated());
    auto again = repeat_netlist(network, kinds, record, {.seed = seed});
    REQUIRE(again);
    CHECK(all_figures(*again, network) == all_figures(report, network));
    auto another = repeat_netlist(network, kinds_of_another, record, {.seed = seed + 1});
    ++(another ? counts.repeated : counts.departed);
    if (another)
        CHECK(all_figures(*another, network) ==
              all_figures(run_netlist(network, kinds_of_another, {.seed = seed + 1}), network));
}

void check_combination(std::uint64_t seed, Counts& counts) {
    Dice dice(seed);
    Combination all;
    draw_operators(all, dice);
    ProblemRegistry problems = known_problems(seed);
    const RecordedProblem& known = problems.find(all.problem);
    auto problem = known.problem()->coded(Coding::named(all.coding));
    draw_islands(all, *problem, seed, dice);
    bool recorded = !problem->objective();
    std::vector<Sample> record = recorded ? known.record() : empty_record(6);
    record.resize(std::min<std::size_t>(record.size(), 12));

    LibraryRun library(*problem, record, all.settings, island_streams(seed, all.settings.islands.size()));
    for (const IslandNetlist& machine : machines(netlist_of(all, recorded, dice), dice)) {
        INFO(test::replay(seed));
        CAPTURE(machine.text());
        Catalogue catalogue = known_kinds(problems);
        ReadResult read = read_netlist_text(machine.text(), catalogue);
        REQUIRE_MESSAGE(read.network, render(read));
        RunReport report = Machine(*read.network, catalogue, seed).run();
        REQUIRE(report.result.ending == Ending::completed);
        for (std::size_t i = 0; i < library.populations.size(); ++i)
            CHECK(report.measured_text(fmt::format("island[{}]", i), "populations") == library.populations[i]);
        check_repeated(*read.network, seed, report, counts);
    }
}

} // namespace

TEST_CASE("random combinations of all policies give the same generations without a machine and on any machine") {
    Counts counts;
    for (std::uint64_t seed : test::seeds(30, 1))
        check_combination(seed, counts);
    CAPTURE(counts.departed);
    if (test::all_seeds())
        CHECK(counts.repeated > 10);
}
