#include "gaprocs/processes/kinds.hpp"

#include "netlist/kinds/catalogue.hpp"

namespace placedpar {

void add_genetic_algorithm_kinds(Catalogue& catalogue, const ProblemRegistry& problems) {
    for (auto kind : {host_kind, traditional_kind, master_kind, slave_kind, island_kind})
        catalogue.add(kind(problems));
}

} // namespace placedpar
