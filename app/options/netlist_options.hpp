#pragma once

#include "app/options.hpp"
#include "netlist/read.hpp"

#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// --set NAME=VALUE, as often as wanted.
Option add_set(Options&, std::vector<std::string>& settings, const std::string& about);

/// What --set, or another option like it, asked for. Throws UserError when one is not of that form or a name is set
/// twice.
Overrides overrides_of(std::span<const std::string> settings, const std::string& option = "--set");

/// What a netlist finds around it, as it is typed.
struct ReadOptionsTyped {
    std::vector<std::string> include, use, fault;
};
/// -I FOLDER, --use PROGRAM=KIND and --fault FAULT, as often as wanted.
std::vector<Option> add_read_options(Options&, ReadOptionsTyped&);
/// Throws UserError when a folder is none, a --use is not of its form or a program is given two kinds.
ReadOptions read_options_of(const ReadOptionsTyped&);

/// What every command with a netlist takes.
struct NetlistOptions {
    std::string file;
    std::vector<std::string> set;
    ReadOptionsTyped read;
};
void add_netlist(Options&, NetlistOptions&);

/// Reads the netlist. Warnings go to standard error. Throws RefusedInput.
Network load_network(const NetlistOptions&);

} // namespace placedpar
