#include "netlist/run_outcome.hpp"

namespace placedpar {

const char* name_of(RunOutcome outcome) {
    switch (outcome) {
    case RunOutcome::completed: return "completed";
    case RunOutcome::time_limit: return "stopped at the time limit";
    case RunOutcome::failed: return "program failed";
    case RunOutcome::halted: return "halted by an error";
    case RunOutcome::deadlock: return "deadlock";
    case RunOutcome::interrupted: return "interrupted";
    }
    return "";
}

} // namespace placedpar
