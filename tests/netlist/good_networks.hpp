#pragma once

#include "netlist/read.hpp"

#include <string>

namespace placedpar {

/// Returns the network of this netlist in tests/netlist/good, which must be free of errors.
Network good(const std::string& name, const Overrides& overrides = {});
/// Returns the network of this text, which must be free of errors.
Network good_text(const std::string& text, const Overrides& overrides = {});

/// Returns the channel of this name, which must exist.
const NetworkChannel& channel(const Network& network, const std::string& name);

} // namespace placedpar
