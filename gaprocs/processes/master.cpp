#include "gaprocs/processes/kinds.hpp"

#include "gaprocs/processes/search_description.hpp"
#include "gaprocs/processes/search_process.hpp"

namespace placedpar {

ProcessKind master_kind(const ProblemRegistry& problems, SearchObserver* observer, Checkpoints* checkpoints) {
    using namespace search_description;
    return searching(
        {.name = "ga.master",
         .about = "The master of algorithm A: deals the population out to its slaves, evaluates a share itself, and "
                  "applies the genetic operators. Without slaves it is the traditional genetic algorithm.",
         .ports = {to_slaves(), from_slaves(), from_host(), to_host()},
         .parameters = search_parameters() + farm_parameters(),
         .measurements = search_measurements(),
         .together = {{"to_slaves", "from_slaves"}}},
        problems, observer, checkpoints);
}

} // namespace placedpar
