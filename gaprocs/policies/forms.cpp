#include "gaprocs/policies/forms.hpp"

namespace placedpar::forms {

Form permutation() {
    return {.name = "permutation",
            .about = "an order of so many places, each of them once, where that is what the problem asks for",
            .written = "problem = \"tour-circle(cities = 12)\"",
            .source = "not in the thesis",
            .example = "run examples/41-own-problem/tin.cfs --set 'problem=\"tour-circle(cities = 12)\"' "
                       "--set 'master.coding=\"natural\"'"};
}

Noun initial_population() {
    return {.name = "initial-population",
            .about = "where a search begins: at random, or with strings of a file",
            .forms = {{.name = "random",
                       .about = "every string is drawn",
                       .written = "initial = \"\"",
                       .source = "thesis 1.1",
                       .example = "run examples/03-table-e1/cluster.cfs --set 'master.initial=\"\"'"},
                      {.name = "predefined",
                       .about = "the strings of a file, one in each line; the others are drawn",
                       .written = "initial = \"first.txt\"",
                       .source = "thesis 6.3, predefined populations",
                       .example = "run examples/03-table-e1/cluster.cfs --set "
                                  "'master.initial=\"examples/03-table-e1/first.txt\"'"},
                      {.name = "spread",
                       .about = "the codes of each field evenly over its range, in an order drawn for each",
                       .written = "initial = \"spread\"",
                       .source = "thesis 6.3, predefined populations; M. McKay et al., 1979",
                       .example = "run examples/03-table-e1/cluster.cfs --set 'master.initial=\"spread\"'"}},
            .also_called = {"population"}};
}

Noun fitness() {
    return {
        .name = "fitness",
        .about = "what makes one individual better than another: the problem decides",
        .forms = {
            {.name = "squared-error",
             .about = "the sum of B - E^2 over a window of samples, of a problem that has an error at each",
             .written = "problem = \"plant\", bias = 10",
             .source = "thesis eq. 3.9, 4.1 and 5.1; without the square 1.7",
             .example = "run examples/62-coarse-fine/pair.cfs --set alone=1"},
            {.name = "maximised",
             .about = "any number that a problem gives for an individual, the greater the better",
             .written = "problem = \"one-max\"",
             .source = "thesis 5.2.2",
             .example =
                 "run examples/41-own-problem/tin.cfs --set 'problem=\"one-max\"' --set 'master.coding=\"natural\"'"},
            {.name = "minimised",
             .about = "any number that a problem gives for an individual, the smaller the better",
             .written = "problem = \"rastrigin\"",
             .source = "not in the thesis",
             .example = "run examples/41-own-problem/tin.cfs --set 'problem=\"rastrigin\"'"}}};
}

Noun window() {
    return {
        .name = "window",
        .about = "which samples of a record the fitness is summed over, and for how many generations",
        .forms = {
            {.name = "sliding",
             .about = "the newest `window` samples; after `trials` generations the next one comes in, and the "
                      "oldest goes",
             .written = "window = 30, first_window = 30, trials = 3",
             .source = "thesis eq. 1.7, 3.9, 4.1 and 5.1; trials: 4.3",
             .example = "run examples/62-coarse-fine/pair.cfs"},
            {.name = "growing",
             .about = "the same, but the first generation comes before the window is full",
             .written = "window = 10, first_window = 5",
             .source = "ours: the thesis does not say",
             .example = "run examples/03-table-e1/cluster.cfs --set master.window=10 --set master.first_window=5"}}};
}

Noun elitism() {
    return {.name = "elitism",
            .about = "how many of the best go over unchanged (thesis: none)",
            .forms = {{.name = "best",
                       .about = "as many of the best as `elite` says go over unchanged, and are evaluated again",
                       .written = "elite = 1",
                       .source = "K. De Jong, 1975",
                       .example = "run examples/03-table-e1/cluster.cfs --set elite=1"}}};
}

Noun distributed_fitness() {
    return {.name = "distributed-fitness",
            .about = "whether islands have the same window and population",
            .forms = {{.name = "distributed",
                       .about = "each island a window and a population of its own, of equal work: the longer the one, "
                                "the smaller the other",
                       .written = "island[0] (window = 30, population = 24); island[3] (window = 10, population = 50);",
                       .source = "thesis 5.3.1 and Table 5.3",
                       .example = "run examples/22-plant-on-transputers/islands.cfs"},
                      {.name = "equal",
                       .about = "the same for all islands",
                       .written = "island[i] (window = 30, population = 24);",
                       .source = "thesis 4.3; beside the other: Table 5.3",
                       .example = "run examples/22-plant-on-transputers/islands.cfs --set distributed=0"}},
            .also_called = {"population"}};
}

Noun coarse_fine() {
    return {.name = "coarse-fine",
            .about = "two searches instead of one: one over a coarse grid, one around its best",
            .forms = {{.name = "coarse",
                       .about = "breeds the most significant bits of each field, the others are 0",
                       .written = "use \"ga.coarse\" for coarse; coarse (bits = \"2 5 5 5 5 5\");",
                       .source = "thesis 6.2, Figure 6.6",
                       .example = "run examples/62-coarse-fine/pair.cfs"},
                      {.name = "fine",
                       .about = "breeds steps around the best of the coarse one in the same generation",
                       .written = "use \"ga.fine\" for fine; connect coarse.to_fine to fine.from_coarse;",
                       .source = "thesis 6.2, Figure 6.6",
                       .example = "run examples/62-coarse-fine/pair.cfs"}},
            .also_called = {"coarse/fine", "pair"}};
}

Noun farm() {
    return {.name = "farm",
            .about = "how a master deals its population out to slaves (thesis, algorithm A): their form is what the "
                     "netlist connects",
            .forms = {{.name = "chain",
                       .about = "one slave behind the other, each passes on what is for those beyond it",
                       .written = "connect master.to_slaves to slave[0].from_master; "
                                  "connect slave[0].to_slaves to slave[1].from_master;",
                       .source = "thesis, appendix E, Figure E.2",
                       .example = "run examples/36-farms/farm.cfs"},
                      {.name = "star",
                       .about = "a channel from the master to each slave",
                       .written = "connect master.to_slaves[0] to slave[0].from_master; "
                                  "connect master.to_slaves[1] to slave[1].from_master;",
                       .source = "thesis, appendix E, which computes .4 ms for it",
                       .example = "run examples/36-farms/farm.cfs --set links=3"},
                      {.name = "tree",
                       .about = "anything between: several slaves behind the master, several behind a slave",
                       .written = "connect master.to_slaves[0] to slave[0].from_master; "
                                  "connect slave[0].to_slaves[1] to slave[2].from_master;",
                       .source = "not in the thesis",
                       .example = "run examples/36-farms/farm.cfs --set slaves=6 --set links=2 --set branches=2"}},
            .also_called = {"algorithm-a"}};
}

} // namespace placedpar::forms
