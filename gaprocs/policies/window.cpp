#include "gaprocs/policies/forms.hpp"

namespace placedpar::forms {

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

} // namespace placedpar::forms
