#pragma once

#include "netlist/read.hpp"

#include <string>

namespace placedpar {

/// The network of the netlist of that name in tests/netlist/good, which is read without a fault.
Network good(const std::string& name, const Overrides& overrides = {});
/// The same of a text.
Network good_text(const std::string& text, const Overrides& overrides = {});

/// The channel of that name, which must be there.
const NetworkChannel& channel(const Network& network, const std::string& name);

} // namespace placedpar
