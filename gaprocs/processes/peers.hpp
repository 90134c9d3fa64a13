#pragma once

#include "netlist/network/network.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

// Whom a process is connected to, as its netlist says: what its checks ask, and the process itself where it must know.

/// The connected ends of a port, in the order of their subscripts; the port is named without one.
std::vector<PortBinding> ends_of(const Network&, std::size_t process, std::string_view port);
/// The other end of that one's channel.
const ChannelEnd& end_beyond(const Network&, const PortBinding&);
/// The other end of the first channel at a port; none where it is not connected.
std::optional<ChannelEnd> other_end(const Network&, std::size_t process, std::string_view port);

struct Peer {
    std::string port;    ///< of the process that was asked about, with its subscript
    std::size_t process; ///< at the other end; nowhere: an edge
};
/// Of each end of a port, in the order of their subscripts.
std::vector<Peer> peers_at(const Network&, std::size_t process, std::string_view port);

} // namespace placedpar
