#include "gaprocs/policies/forms.hpp"

namespace placedpar::forms {

Noun elitism() {
    return {.name = "elitism",
            .about = "how many of the best go over unchanged (thesis: none)",
            .forms = {{.name = "best",
                       .about = "as many of the best as `elite` says go over unchanged, and are evaluated again",
                       .written = "elite = 1",
                       .source = "K. De Jong, 1975",
                       .example = "run examples/03-table-e1/cluster.cfs --set elite=1"}}};
}

} // namespace placedpar::forms
