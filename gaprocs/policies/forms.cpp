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

Form predefined() {
    return {.name = "predefined",
            .about = "the strings of a file, one in each line; the others are drawn",
            .written = "initial = \"first.txt\"",
            .source = "thesis 6.3, predefined populations",
            .example = "run examples/03-table-e1/cluster.cfs --set "
                       "'master.initial=\"examples/03-table-e1/first.txt\"'"};
}

} // namespace placedpar::forms
