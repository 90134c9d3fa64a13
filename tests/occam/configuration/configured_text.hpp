#pragma once

#include "netlist/read.hpp"

#include <string>

namespace placedpar::test {

/// Returns options with which configurations are read as netlists.
ReadOptions configuration_options();

/// A netlist that was made of a configuration, or the messages that refuse it.
struct MadeText {
    std::string netlist, messages;
};
MadeText made_from(const std::filesystem::path&);

} // namespace placedpar::test
