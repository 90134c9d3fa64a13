#pragma once

#include "netlist/network/network.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

// These functions find the processes to which a process is connected in the netlist.

/// Returns the connected ends of a port, which may be an array, in the order of their subscripts. REQUIRES: `port` is
/// without a subscript.
std::vector<PortBinding> ends_of(const Network&, std::size_t process, std::string_view port);
/// Returns the other end of the channel at this port.
const ChannelEnd& end_beyond(const Network&, const PortBinding&);
/// Returns the other end of the first channel at a port, or nothing if the port is not connected.
std::optional<ChannelEnd> other_end(const Network&, std::size_t process, std::string_view port);

struct Peer {
    std::string port;    ///< port of this process, with its subscript
    std::size_t process; ///< index of the process at the other end; `nowhere` if the other end is an edge of the
                         ///< network
};
/// Returns the peer at each end of a port, in the order of the subscripts.
std::vector<Peer> peers_at(const Network&, std::size_t process, std::string_view port);

} // namespace placedpar
