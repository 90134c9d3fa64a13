#pragma once

#include "runtime/process.hpp"
#include "runtime/time.hpp"

#include <string>

namespace placedpar {

/// A part of a run's critical path: from the part before it, or the beginning of the run, until a moment.
struct PathPart {
    Activity activity;   ///< starting, computing, carrying (a message), moving, arbitrating, delayed, ready or ended
    std::string subject; ///< "master on t[0]"; the channel; the process
    std::string place;   ///< the processor, direction of a link, or bus that it took; "" for none
    Time begin, end;     ///< begin < end
};

/// "communicating"; "" for what no part of a path is.
const char* name_on_path(Activity);
/// "computing: master on t[0]".
std::string name_on_path(Activity, const std::string& subject);

} // namespace placedpar
