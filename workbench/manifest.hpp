#pragma once

#include "netlist/network/network.hpp"
#include "netlist/read.hpp"

#include <boost/json.hpp>

#include <cstdint>
#include <string>

namespace placedpar {

/// What is needed to run it again.
struct Manifest {
    std::string command; ///< as it was typed
    std::uint64_t seed;
    Overrides overrides;
    ReadOptions read = {};
};

extern const char* const version;
/// Of the sources, as `git describe` names it, with "-dirty" where they were changed since; "" where it is not known.
extern const char* const commit;

/// "0.1.0 (commit 2ec56e0)".
std::string version_text();

/// {"version", "commit", "command", "netlist", "netlist_hash", "overrides", "programs", "include_folders", "seed"}
boost::json::object manifest_json(const Manifest&, const Network&);

/// Indented, so that people can read it; ends with a newline. Numbers that are not finite become null.
std::string print_pretty(const boost::json::value&);

std::string hex(std::uint64_t);

} // namespace placedpar
