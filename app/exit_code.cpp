#include "app/exit_code.hpp"

namespace placedpar {

ExitCode exit_code_of(Ending ending) {
    switch (ending) {
    case Ending::stuck: return ExitCode::deadlock;
    case Ending::interrupted: return ExitCode::interrupted;
    case Ending::completed:
    case Ending::time_limit: break;
    }
    return ExitCode::success;
}

} // namespace placedpar
