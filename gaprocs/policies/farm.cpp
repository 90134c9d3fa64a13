#include "gaprocs/policies/forms.hpp"

namespace placedpar::forms {

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
