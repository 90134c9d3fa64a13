#pragma once

#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/workload.hpp"
#include "gaprocs/recoded_problem.hpp"
#include "runtime/channel.hpp"

namespace placedpar {

class ProcessEnvironment;

/// An end of the channel between a coarse and a fine search (see CoarseFine, gaprocs/coarse_fine.hpp). In each
/// generation the coarse search sends its best string, the bias point. The fine search, which searches only around the
/// bias point, receives it before it evaluates the same generation.
class BiasPointEnd {
public:
    /// `problem` reads the bred strings; in a fine search, before_generation() moves it to the bias point. REQUIRES:
    /// `problem` outlives this object.
    BiasPointEnd(const ProcessEnvironment&, RecodedProblem&, const Workload&);

    /// In a fine search, waits for the bias point of this generation, and moves the problem to it.
    void before_generation();
    /// In a coarse search, converts `best` to a string of the problem, and sends it as the bias point. `best` is the
    /// best string of the generation, as the coarse search breeds it.
    void after_generation(const Genome& best);

private:
    RecodedProblem& problem_;
    std::uint32_t string_bytes_;
    Output<BiasPoint> to_fine_;    ///< not connected in a fine search
    Input<BiasPoint> from_coarse_; ///< not connected in a coarse search
};

} // namespace placedpar
