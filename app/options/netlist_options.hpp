#pragma once

#include "app/options.hpp"
#include "netlist/read.hpp"

#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// Declares --set NAME=VALUE, which may be repeated.
Option add_set(Options&, std::vector<std::string>& settings, const std::string& about);

/// Parses the values of --set, or of another option of the form NAME=VALUE. Throws UserError if a value does not have
/// the form NAME=VALUE, or if a name is set twice.
Overrides overrides_of(std::span<const std::string> settings, const std::string& option = "--set",
                       const std::string& example = "slaves=3");

/// The options for reading a netlist, as typed.
struct ReadOptionsTyped {
    std::vector<std::string> include, use, fault;
};
/// Declares -I FOLDER, --use PROGRAM=KIND and --fault FAULT, which may be repeated.
std::vector<Option> add_read_options(Options&, ReadOptionsTyped&);
/// Throws UserError if a folder does not exist, a --use does not have the form PROGRAM=KIND, or a program is given two
/// kinds.
ReadOptions read_options_of(const ReadOptionsTyped&);

/// The options of every command that reads a netlist.
struct NetlistOptions {
    std::string file;
    std::vector<std::string> set;
    ReadOptionsTyped read;
};
void add_netlist(Options&, NetlistOptions&);

/// Reads the netlist. Prints warnings to standard error. Throws RefusedInput.
Network load_network(const NetlistOptions&);

} // namespace placedpar
