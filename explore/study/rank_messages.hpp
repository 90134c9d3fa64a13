#pragma once

#include "explore/study/results.hpp"

#include <optional>
#include <string>

namespace placedpar {

/// The messages between the ranks of mpirun that make the runs of a study. Rank 0 has the results; the other ranks are
/// the helpers.
///
///     rank 0                      helper
///     begin                  ->                        or `stop`, if there is nothing to do
///                            <-   ask                  n + 1 times, if the helper makes n runs at a time
///     run                    ->                        for each `ask` and `ended`; or `none`, if no run is left
///                            <-   ended                the outcome of a run; also asks for another run
///     stop                   ->                        only if rank 0 is interrupted or fails
///                            <-   failed               only after an error; the helper then waits for `stop`
///                            <-   gone                 the helper's last message
struct RankMessage {
    enum class Kind { begin, run, none, stop, ask, ended, failed, gone } kind;
    std::string text = "";                    ///< in `begin`: digest_of() the source; in `failed`: the reason
    std::optional<StudyRun> run = {};         ///< set in `run` and in `ended`
    std::optional<StudyOutcome> outcome = {}; ///< set in `ended`
};

std::string text_of(const RankMessage&);
/// Reads the message back, without any loss. REQUIRES: the text was made by text_of() of the same version.
RankMessage rank_message_from(const std::string&);

/// Returns a digest of the netlist, its included files, the options and the version of PlacedPar. Two digests are equal
/// only if all these are equal. By the digest a helper finds out whether it makes the same runs as rank 0.
std::string digest_of(const StudySource&);

} // namespace placedpar
