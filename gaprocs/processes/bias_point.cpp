#include "gaprocs/processes/bias_point.hpp"

#include "netlist/kinds/environment.hpp"

#include <utility>

namespace placedpar {

BiasPointEnd::BiasPointEnd(const ProcessEnvironment& environment, RecodedProblem& problem, const Workload& workload)
    : problem_(problem), string_bytes_(workload.string_bytes) {
    if (environment.connected("to_fine"))
        to_fine_ = environment.output<BiasPoint>("to_fine");
    if (environment.connected("from_coarse"))
        from_coarse_ = environment.input<BiasPoint>("from_coarse");
}

void BiasPointEnd::before_generation() {
    if (from_coarse_)
        problem_.move_to(from_coarse_.input().string);
}

void BiasPointEnd::after_generation(const Genome& best) {
    if (!to_fine_)
        return;
    BiasPoint point;
    point.string = problem_.to_problem(best);
    point.bytes = message_bytes(1, string_bytes_);
    to_fine_.output(std::move(point));
}

} // namespace placedpar
