#pragma once

#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/workload.hpp"
#include "gaprocs/recoded_problem.hpp"
#include "runtime/channel.hpp"

namespace placedpar {

class ProcessEnvironment;

/// An end of the channel between the two searches of a pair (see CoarseFine, gaprocs/coarse_fine.hpp). In each
/// generation the coarse search sends its best string, the bias point. The fine search receives the bias point before
/// it evaluates the same generation.
class BiasPointEnd {
public:
    /// REQUIRES: `problem` outlives this object.
    BiasPointEnd(const ProcessEnvironment&, RecodedProblem&, const Workload&);

    void before_generation();
    /// In a coarse search, sends the bias point. `best` is the best individual of the generation, in the coding of the
    /// coarse search.
    void after_generation(const Genome& best);

private:
    RecodedProblem& problem_;
    std::uint32_t string_bytes_;
    Output<BiasPoint> to_fine_;    ///< not connected in a fine search
    Input<BiasPoint> from_coarse_; ///< not connected in a coarse search
};

} // namespace placedpar
