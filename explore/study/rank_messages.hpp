#pragma once

#include "explore/study/results.hpp"

#include <optional>
#include <string>

namespace placedpar {

/// What the ranks of a sweep say to each other: rank 0, which has the results, and the others, its helpers.
///
///     rank 0                      helper
///     begin                  ->                        or, where it comes to nothing, stop
///                            <-   ask, ask ...         one more than it makes runs at once
///     run                    ->                        for each that asked; none when there are no more
///                            <-   ended, asks again
///     stop                   ->                        only where rank 0 is interrupted, or fails
///                            <-   gone                 its last word; failed, where it cannot go on
struct RankMessage {
    enum class Kind { begin, run, none, stop, ask, ended, failed, gone } kind;
    std::string text = "";                    ///< of begin: what is swept (digest_of); of failed: why
    std::optional<StudyRun> run = {};         ///< of run and ended
    std::optional<StudyOutcome> outcome = {}; ///< of ended
};

std::string text_of(const RankMessage&);
/// The same to the last bit. REQUIRES: text_of() made it, of the same version.
RankMessage rank_message_from(const std::string&);

/// The same only where the netlist with all that it includes, the options and PlacedPar are the same.
std::string digest_of(const StudySource&);

} // namespace placedpar
