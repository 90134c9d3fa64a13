#pragma once

#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/workload.hpp"
#include "gaprocs/recoded_problem.hpp"
#include "runtime/channel.hpp"

namespace placedpar {

class ProcessEnvironment;

/// One end of the channel of a pair (CoarseFine, gaprocs/coarse_fine.hpp): in each generation the coarse search sends
/// its best, and the fine one moves there before it evaluates the same generation. A coarse search without a fine one
/// sends nothing.
class BiasPointEnd {
public:
    /// REQUIRES: the problem outlives this.
    BiasPointEnd(const ProcessEnvironment&, RecodedProblem&, const Workload&);

    void before_generation();
    /// Sends the bias point. `best`: the best individual of the generation, as the search breeds it.
    void after_generation(const Genome& best);

private:
    RecodedProblem& problem_;
    std::uint32_t string_bytes_;
    Output<BiasPoint> to_fine_;    ///< not connected in a fine search
    Input<BiasPoint> from_coarse_; ///< not connected in a coarse search
};

} // namespace placedpar
