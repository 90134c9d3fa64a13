#pragma once

#include "explore/study/results.hpp"

#include <optional>
#include <string>

namespace placedpar {

/// The messages of a sweep between rank 0, which has the results, and the other ranks, the helpers.
///
///     rank 0                      helper
///     begin                  ->                        or stop, if there is nothing to do
///                            <-   ask, ask ...         one more than the runs that it makes at once
///     run                    ->                        one for each ask; none if no runs are left
///                            <-   ended                which also asks for another run
///     stop                   ->                        only if rank 0 is interrupted or fails
///                            <-   gone                 its last message; or failed, if it cannot go on
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
/// only if all these are equal.
std::string digest_of(const StudySource&);

} // namespace placedpar
