#include "observe/trace/path_part.hpp"

namespace placedpar {

const char* name_on_path(Activity activity) {
    switch (activity) {
    case Activity::starting: return "starting";
    case Activity::computing: return "computing";
    case Activity::carrying: return "communicating";
    case Activity::moving: return "moving words";
    case Activity::arbitrating: return "arbitrating";
    case Activity::delayed: return "delayed";
    case Activity::ready: return "ready, not running";
    case Activity::ended: return "nothing more";
    case Activity::executing:
    case Activity::outputting:
    case Activity::inputting:
    case Activity::alternating:
    case Activity::joining:
    case Activity::after_work:
    case Activity::stopped:
    case Activity::halted: break;
    }
    return "";
}

std::string name_on_path(Activity activity, const std::string& subject) {
    return std::string(name_on_path(activity)) + (subject.empty() ? "" : ": ") + subject;
}

} // namespace placedpar
