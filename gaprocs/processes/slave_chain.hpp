#pragma once

#include "netlist/kinds/catalogue.hpp"
#include "netlist/network/network.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace placedpar {

/// The slaves of a master as a netlist connects them.
struct SlaveChain {
    std::vector<std::size_t> slaves; ///< processes, the nearest to the master first
    bool known = true;               ///< false where a process that is no ga.slave is among them
    std::vector<Complaint> complaints;
};

/// Follows the tasks from the master on. Complains of a slave whose results do not return to the process that sends its
/// tasks; the chain ends there and is not known.
SlaveChain follow_slaves(const Network&, std::size_t master);

/// The other end of the channel at a port; none where it is not connected.
std::optional<ChannelEnd> other_end(const Network&, std::size_t process, std::string_view port);

} // namespace placedpar
