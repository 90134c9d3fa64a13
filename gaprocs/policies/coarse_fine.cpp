#include "gaprocs/policies/forms.hpp"

namespace placedpar::forms {

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

} // namespace placedpar::forms
