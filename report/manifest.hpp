#pragma once

#include "netlist/network/network.hpp"
#include "netlist/read.hpp"
#include "runtime/time.hpp"

#include <boost/json/fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace placedpar {

/// Holds the data that are needed to repeat a run.
struct Manifest {
    std::string command; ///< the command as it was typed
    std::uint64_t seed;
    Overrides overrides;
    ReadOptions read = {};
    Time until = Time::max(); ///< time limit of the run, in simulated time
    std::optional<std::uint64_t> shuffle = {};
};

extern const char* const version;
/// The commit of the sources as `git describe` names it, with "-dirty" if the sources were changed after this commit;
/// "" if the commit is unknown.
extern const char* const commit;

/// Returns a text such as "0.1.0 (commit 2ec56e0)".
std::string version_text();

/// Returns an object with the keys "version", "commit", "command", "netlist", "netlist_hash", "overrides", "set",
/// "programs", "include_folders" and "seed". "overrides" has the options as given; "set" lists the processes, nodes and
/// wires that each option changed; the list is empty for a constant (`val`). "faults" is present if options stated
/// faults, "until_ps" if a stopping time was given, "shuffle" if the run was shuffled.
boost::json::object manifest_json(const Manifest&, const Network&);

/// Prints the value with indentation and a final newline. Numbers that are not finite become null.
std::string print_pretty(const boost::json::value&);

std::string hex(std::uint64_t);

} // namespace placedpar
