#pragma once

#include "netlist/read.hpp"

#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace placedpar {

/// --set NAME=VALUE, as often as wanted.
CLI::Option* add_set(CLI::App&, std::vector<std::string>& settings, const std::string& about);

/// What --set asked for. Throws UserError when one is not of that form or a name is set twice.
Overrides overrides_of(std::span<const std::string> settings);

/// What every command with a netlist takes.
struct NetlistOptions {
    std::string file;
    std::vector<std::string> set;
};
void add_netlist(CLI::App&, NetlistOptions&);

/// Reads the netlist. Warnings go to standard error. Throws RefusedInput.
Network load_network(const NetlistOptions&);

} // namespace placedpar
