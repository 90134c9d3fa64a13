#pragma once

#include "netlist/machine.hpp"
#include "netlist/read.hpp"

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace placedpar {

/// A netlist that was refused; what() is the rendered diagnostics.
class RefusedNetlist : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Reads a netlist with this program's kinds. Warnings go to standard error. Throws RefusedNetlist.
Network load_network(const std::filesystem::path&, const Overrides&);

/// Loads a netlist and runs it. SIGINT and SIGTERM end the run early. `trace` may be null.
/// Throws RefusedNetlist, and what the processes throw.
RunReport run_netlist(const Network&, std::uint64_t seed, Time limit = Time::max(), TraceSink* trace = nullptr);

} // namespace placedpar
