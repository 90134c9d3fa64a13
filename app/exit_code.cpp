#include "app/exit_code.hpp"

namespace placedpar {

ExitCode exit_code_of(RunOutcome outcome) {
    switch (outcome) {
    case RunOutcome::failed:
    case RunOutcome::halted: return ExitCode::bad_input;
    case RunOutcome::deadlock: return ExitCode::deadlock;
    case RunOutcome::interrupted: return ExitCode::interrupted;
    case RunOutcome::completed:
    case RunOutcome::time_limit: break;
    }
    return ExitCode::success;
}

} // namespace placedpar
