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

/// The options of a command that runs code on emulated transputers. They describe the host, the computer that boots the
/// transputers and serves them with files and a terminal. For a program without a netlist, they also describe the
/// single transputer that runs the program.
struct BootedOptions : ProgramMachine {
    std::string folder;
    /// The keys for the booted program. If nullopt, the keys come from this program's terminal or standard input.
    std::optional<std::string> keys;
    std::vector<std::string> environment;
    std::uint64_t write_limit_megabytes = 64;
    std::vector<std::string> arguments; ///< command-line arguments of the program
};
/// Declares all of these options.
void add_booted(Options&, BootedOptions&);
/// Declares only the options that describe the transputer.
void add_machine(Options&, BootedOptions&, const std::string& heading);
/// Declares only the options that describe the host.
void add_host(Options&, BootedOptions&, const std::string& heading);

/// Returns the services that the host offers to its program, except the terminal. Throws UserError if the options set
/// an environment variable twice.
HostServices services_of(const BootedOptions&);

/// Returns a function that makes the terminal at which a booted program reads keys and writes to the screen. If the
/// option --keys is given, the booted program reads the keys that this option lists. Otherwise the booted program reads
/// the keys of this program's own terminal or standard input. If `uses_standard_input` is false, it reads no keys.
/// Throws UserError if the text of --keys is wrong. `interrupted` returns whether to end a wait for a key, and may be
/// called while the booted program's terminal exists. `unread` is called if the output cannot be written because its
/// reader, another process, has ended.
std::function<std::shared_ptr<iserver::Terminal>()> terminal_for(const BootedOptions&,
                                                                 std::function<bool()> interrupted,
                                                                 std::function<void()> unread,
                                                                 bool uses_standard_input = true);

/// Reads the netlist. If the file is bootable code, makes a network of one transputer with a host that boots it. Gives
/// the network's hosts the services that the options describe. Throws RefusedInput; throws UserError if an option does
/// not fit the file.
Network load_network(const Options&, const NetlistOptions&, const BootedOptions&);

} // namespace placedpar
