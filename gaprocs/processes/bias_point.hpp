#pragma once

#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/workload.hpp"
#include "gaprocs/recoded_problem.hpp"
#include "runtime/channel.hpp"

namespace placedpar {

class ProcessEnvironment;

/// One end of the channel of a pair (CoarseFine, gaprocs/coarse_fine.hpp): in each generation the coarse search sends
/// its best, and the fine one moves there before it evaluates the same generation. A coarse search alone sends to
/// nobody.
class BiasPointEnd {
public:
    /// REQUIRES: the problem outlives this.
    BiasPointEnd(const ProcessEnvironment&, RecodedProblem&, const Workload&);

    void before_generation();
    /// `best` of the generation, as it is bred.
    void after_generation(const Genome& best);

private:
    RecodedProblem& problem_;
    std::uint32_t string_bytes_;
    Output<BiasPoint> to_fine_;    ///< without a channel in the fine search
    Input<BiasPoint> from_coarse_; ///< without a channel in the coarse search
};

} // namespace placedpar
