#include "app/options/occam_options.hpp"

namespace placedpar {

void add_occam(Options& command, OccamOptions& options) {
    const std::string heading = "Programs in occam";
    command
        .add("--mode", options.mode,
             "what an error of an occam program does: halts its processor (halt), stops its process (stop), or halts "
             "the processor if it can halt, and otherwise stops the process (universal)")
        .one_of({"halt", "stop", "universal"})
        .show_default()
        .group(heading);
    command.add("--no-checks", options.no_checks, "checks to leave out for an occam program: usage, alias, range, all")
        .type("CHECKS")
        .group(heading);
}

} // namespace placedpar
