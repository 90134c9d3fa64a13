#pragma once

#include "app/options.hpp"
#include "app/standard_error.hpp"
#include "explore/load.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// Declares --set NAME=VALUE, which changes a value of the netlist and may be repeated.
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
/// Throws UserError if a folder does not exist, if a --use does not have the form PROGRAM=KIND, or if two --use name
/// the same program.
ReadOptions read_options_of(const ReadOptionsTyped&);

/// The options of every command that reads a netlist.
struct NetlistOptions {
    std::string file;
    std::vector<std::string> set;
    ReadOptionsTyped read;
    std::string calibration = ""; ///< file of --predict; "" to simulate the netlist's own machine
    std::size_t threads = 0;      ///< number of threads of the predicted run; 0: one for each core of this computer
    std::size_t ranks = 0;        ///< number of ranks of the predicted run; 0: the run is on threads
    WarningSink warn = print_warnings;
};
void add_netlist(Options&, NetlistOptions&);
/// Declares --predict and --ranks. The command itself declares --threads.
void add_predict(Options&, NetlistOptions&);

/// A netlist with the settings of --set.
struct TypedNetlist {
    ParsedNetlist parsed;
    Overrides set;
};
/// Parses the netlist. With --predict, returns instead the netlist that models the native run
/// (explore/prediction/native_netlist.hpp), to which no settings apply. Throws as load_network() does.
TypedNetlist parse_netlist(const NetlistOptions&, const WarningSink&);

/// Reads the netlist. Throws RefusedInput.
Network load_network(const NetlistOptions&);

} // namespace placedpar
