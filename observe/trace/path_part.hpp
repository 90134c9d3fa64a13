#pragma once

#include "runtime/process.hpp"
#include "runtime/time.hpp"

#include <string>

namespace placedpar {

/// A part of a run's critical path, the chain of activities that determines when the run ends. A part begins when the
/// preceding part ends; the first part begins with the run.
struct PathPart {
    Activity activity;   ///< starting, computing, carrying (a message), moving, arbitrating, delayed, ready or ended
    std::string subject; ///< a process with its processor ("master on t[0]"), a channel, a bus, or a process alone
    std::string place;   ///< the processor, direction of a link, or bus that this part used; "" if none
    Time begin, end;     ///< begin < end
};

/// Returns the activity's name, such as "communicating"; "" for an activity that parts of a path cannot have.
const char* name_on_path(Activity);
/// Returns a text such as "computing: master on t[0]".
std::string name_on_path(Activity, const std::string& subject);

} // namespace placedpar
