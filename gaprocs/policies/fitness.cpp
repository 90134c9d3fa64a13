#include "gaprocs/policies/forms.hpp"

namespace placedpar::forms {

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

} // namespace placedpar::forms
