#pragma once

#include "app/options.hpp"
#include "app/options/netlist_options.hpp"
#include "app/options/occam_options.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// The options of a command that runs transputers which execute code: the options of the host and, for a program
/// without a netlist, of its transputer.
struct BootedOptions : ProgramMachine {
    std::string folder;
    std::optional<std::string> keys; ///< no value: keys come from the terminal or standard input
    std::vector<std::string> environment;
    std::uint64_t write_limit_megabytes = 64;
    std::vector<std::string> arguments; ///< command-line arguments of the program
};
/// Declares all of these options.
void add_booted(Options&, BootedOptions&);
/// Declares the options for the transputer alone.
void add_machine(Options&, BootedOptions&, const std::string& heading);
/// Declares the options for the host alone.
void add_host(Options&, BootedOptions&, const std::string& heading);

/// Returns the services of the host for its program, except the terminal. Throws UserError for a variable that is set
/// twice.
HostServices services_of(const BootedOptions&);

/// Returns a function that makes the terminal of a program: the keys that were typed as an option, or else the terminal
/// of PlacedPar. Throws UserError if the keys cannot be read. `interrupted` returns whether to end a wait for a key; it
/// is called while a terminal exists. `unread` is called when the reader of the screen has gone. If there is no
/// standard input, only the keys of the option are pressed.
std::function<std::shared_ptr<iserver::Terminal>()> terminal_for(const BootedOptions&,
                                                                 std::function<bool()> interrupted,
                                                                 std::function<void()> unread,
                                                                 bool uses_standard_input = true);

/// Reads the netlist. If the file is bootable, makes a network of one transputer with a host that boots it. Gives the
/// network's hosts the services that the options describe. Throws RefusedInput; throws UserError if an option does not
/// fit the file.
Network load_network(const Options&, const NetlistOptions&, const BootedOptions&);

} // namespace placedpar
