#pragma once

#include "netlist/network/network.hpp"
#include "netlist/read.hpp"
#include "runtime/time.hpp"

#include <boost/json/fwd.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace placedpar {

/// What is needed to run it again.
struct Manifest {
    std::string command; ///< as it was typed
    std::uint64_t seed;
    Overrides overrides;
    ReadOptions read = {};
    Time until = Time::max(); ///< where the run was to be stopped
    std::optional<std::uint64_t> shuffle = {};
};

extern const char* const version;
/// Of the sources, as `git describe` names it, with "-dirty" where they were changed since; "" where it is not known.
extern const char* const commit;

/// "0.1.0 (commit 2ec56e0)".
std::string version_text();

/// {"version", "commit", "command", "netlist", "netlist_hash", "overrides", "set", "programs", "include_folders",
/// "seed"}. The overrides are as they were asked for; "set" says which elements each of them reached, none for a val.
/// With "until_ps" where the run was to be stopped, "shuffle" where it was shuffled.
boost::json::object manifest_json(const Manifest&, const Network&);

/// Indented, so that people can read it; ends with a newline. Numbers that are not finite become null.
std::string print_pretty(const boost::json::value&);

std::string hex(std::uint64_t);

} // namespace placedpar
