#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/processes/search_process.hpp"

namespace placedpar {

ProcessKind traditional_kind(const ProblemRegistry& problems, SearchObserver* observer, Checkpoints* checkpoints) {
    using namespace search_description;
    return searching({.name = "ga.traditional",
                      .about = "The traditional genetic algorithm: one population, on one processor.",
                      .ports = {from_host(), to_host()},
                      .parameters = search_parameters(),
                      .measurements = search_measurements()},
                     problems, observer, checkpoints);
}

} // namespace placedpar
