#include "gaprocs/processes/kinds.hpp"

#include "netlist/kinds/catalogue.hpp"

namespace placedpar {

void add_genetic_algorithm_kinds(Catalogue& catalogue, const ProblemRegistry& problems, SearchObserver* observer,
                                 Checkpoints* checkpoints) {
    for (auto kind : {host_kind, slave_kind, pipeline_kind, sensors_kind, alarm_kind})
        catalogue.add(kind(problems));
    for (auto searching_kind : {traditional_kind, master_kind, island_kind})
        catalogue.add(searching_kind(problems, observer, checkpoints));
    for (auto searching_kind : {analyst_kind, coarse_kind, fine_kind})
        catalogue.add(searching_kind(problems, observer));
}

} // namespace placedpar
