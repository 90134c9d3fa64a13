#include "gaprocs/policies/forms.hpp"

namespace placedpar::forms {

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

} // namespace placedpar::forms
