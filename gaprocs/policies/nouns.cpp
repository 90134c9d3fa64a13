#include "gaprocs/policies/nouns.hpp"

#include "gaprocs/policies/acceptance.hpp"
#include "gaprocs/policies/coding.hpp"
#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/emigration.hpp"
#include "gaprocs/policies/initial_population.hpp"
#include "gaprocs/policies/island_choice.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "gaprocs/policies/reproduction.hpp"
#include "gaprocs/policies/schedule.hpp"
#include "gaprocs/policies/topology.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace placedpar {

namespace {

/// Each row lists the members of a Form in their order of declaration.
const std::vector<Form> forms{
    {"representation", "permutation",
     "a permutation: it contains each element of the problem, such as a city, once; only for problems that ask for an "
     "order",
     "problem = \"tour-circle(cities = 12)\"", "not in the thesis",
     "run examples/genetic/own-problem/tin.cfs --set 'problem=\"tour-circle(cities = 12)\"' --set "
     "'master.coding=\"natural\"'"},
    {"initial-population", "predefined",
     "strings read from a file, one in each line; if the file has too few strings, the others are drawn at random",
     "initial = \"first.txt\"", "thesis 6.3, predefined populations",
     "run examples/thesis/table-e1/cluster.cfs --set 'master.initial=\"examples/thesis/table-e1/first.txt\"'"},
    {"fitness", "squared-error",
     "the sum of B - E^2 over a window of samples, for a problem with an error at each sample",
     "problem = \"plant\", bias = 10", "thesis eq. 3.9, 4.1 and 5.1; eq. 1.7 without the square",
     "run examples/genetic/coarse-fine/pair.cfs --set alone=1"},
    {"fitness", "maximised", "a number that the problem computes for an individual; the greatest is the best",
     "problem = \"one-max\"", "thesis 5.2.2",
     "run examples/genetic/own-problem/tin.cfs --set 'problem=\"one-max\"' --set 'master.coding=\"natural\"'"},
    {"fitness", "minimised", "a number that the problem computes for an individual; the smallest is the best",
     "problem = \"rastrigin\"", "not in the thesis",
     "run examples/genetic/own-problem/tin.cfs --set 'problem=\"rastrigin\"'"},
    {"window", "sliding", "the newest `window` samples; after `trials` generations the next sample replaces the oldest",
     "window = 30, first_window = 30, trials = 3", "thesis eq. 1.7, 3.9, 4.1 and 5.1; section 4.3 for `trials`",
     "run examples/genetic/coarse-fine/pair.cfs"},
    {"window", "growing", "a sliding window whose first generation comes before the window is full",
     "window = 10, first_window = 5", "PlacedPar's choice: the thesis states none",
     "run examples/thesis/table-e1/cluster.cfs --set master.window=10 --set master.first_window=5"},
    {"elitism", "best", "the `elite` best individuals are copied unchanged, and evaluated again", "elite = 1",
     "K. De Jong, 1975", "run examples/thesis/table-e1/cluster.cfs --set elite=1"},
    {"distributed-fitness", "distributed",
     "each island has its own window and population; a longer window has a smaller population, so that the work is "
     "equal",
     "island[0] (window = 30, population = 24); island[3] (window = 10, population = 50);",
     "thesis 5.3.1 and Table 5.3", "run examples/genetic/plant-on-transputers/islands.cfs"},
    {"distributed-fitness", "equal", "all islands have the same window and population",
     "island[i] (window = 30, population = 24);", "thesis 4.3; compared in Table 5.3",
     "run examples/genetic/plant-on-transputers/islands.cfs --set distributed=0"},
    {"coarse-fine", "coarse", "breeds the most significant bits of each field; the other bits are 0",
     "use \"ga.coarse\" for coarse; coarse (bits = \"2 5 5 5 5 5\");", "thesis 6.2, Figure 6.6",
     "run examples/genetic/coarse-fine/pair.cfs"},
    {"coarse-fine", "fine", "breeds small offsets from the coarse search's best individual of the same generation",
     "use \"ga.fine\" for fine; connect coarse.to_fine to fine.from_coarse;", "thesis 6.2, Figure 6.6",
     "run examples/genetic/coarse-fine/pair.cfs"},
    {"farm", "chain", "each slave is connected to the next, and passes on the messages of the slaves farther away",
     "connect master.to_slaves to slave[0].from_master; connect slave[0].to_slaves to slave[1].from_master;",
     "thesis, appendix E, Figure E.2", "run examples/genetic/farms/farm.cfs"},
    {"farm", "star", "the master has a channel to each slave",
     "connect master.to_slaves[0] to slave[0].from_master; connect master.to_slaves[1] to slave[1].from_master;",
     "thesis, appendix E, which computes .4 ms for a star", "run examples/genetic/farms/farm.cfs --set links=3"},
    {"farm", "tree", "any other tree, with several slaves behind the master or behind a slave",
     "connect master.to_slaves[0] to slave[0].from_master; connect slave[0].to_slaves[1] to slave[2].from_master;",
     "not in the thesis", "run examples/genetic/farms/farm.cfs --set slaves=6 --set links=2 --set branches=2"}};

template <class Step>
Noun noun_of(std::vector<std::string> also_called = {}) {
    return {.name = std::string(Step::noun),
            .about = std::string(Step::about),
            .also_called = std::move(also_called),
            .policies = Step::descriptions(),
            .printed = [](const std::string& text) { return Step::named(text).text(); }};
}

/// Describes a step as noun_of() does, and adds to each policy the kinds of strings on which the policy works.
template <class Step>
Noun noun_of_operator(std::vector<std::string> also_called) {
    Noun noun = noun_of<Step>(std::move(also_called));
    for (StringKind kind : {StringKind::binary, StringKind::real, StringKind::permutation})
        for (const std::string& name : Step::fitting(kind))
            std::ranges::find(noun.policies, name, &PolicyDescription::name)->strings.emplace_back(name_of(kind));
    return noun;
}

} // namespace

std::vector<Noun> policy_nouns() {
    std::vector<Noun> nouns{
        noun_of<Coding>({"encoding", "genome"}),
        noun_of<InitialPopulation>({"population"}),
        {"fitness", "how good an individual is; the problem defines it"},
        {"window",
         "the samples of a record over which the fitness is summed, and the number of generations for each sample"},
        noun_of<Reproduction>(),
        noun_of_operator<Crossover>({"crossover-rate", "operator"}),
        noun_of_operator<Mutation>({"mutation-rate", "operator"}),
        {"elitism", "how many of the best individuals are copied unchanged (thesis: none)"},
        noun_of<Topology>({"migration", "neighbours"}),
        noun_of<Schedule>({"migration"}),
        noun_of<Emigration>({"migration", "emigrants", "migrants"}),
        noun_of<Acceptance>({"migration", "immigration", "immigrants", "replacement"}),
        {"distributed-fitness", "whether islands have the same window and population", {"population"}},
        noun_of<IslandChoice>({"active-error-analysis", "error-matrix"}),
        {"coarse-fine",
         "two searches: the coarse search covers a coarse grid; the fine search covers the surroundings of the coarse "
         "search's best point",
         {"coarse/fine", "pair"}},
        {"farm",
         "how a master divides its population among slaves (thesis, algorithm A); the netlist connects the slaves in a "
         "chain, a star or a tree",
         {"algorithm-a"}}};
    for (Noun& noun : nouns)
        std::ranges::copy_if(forms, std::back_inserter(noun.forms),
                             [&](const Form& form) { return form.noun == noun.name; });
    return nouns;
}

} // namespace placedpar
