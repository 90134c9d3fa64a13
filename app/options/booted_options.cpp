#include "app/options/booted_options.hpp"

#include "app/options/common_options.hpp"
#include "app/standard_error.hpp"
#include "explore/check/check_file.hpp"
#include "explore/load.hpp"
#include "explore/problems.hpp"
#include "iserver/console.hpp"
#include "netlist/kinds/bootable_file.hpp"
#include "occam/configuration/configuration.hpp"
#include "runtime/transputer/model.hpp"
#include "text/number.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>

namespace placedpar {

namespace {

constexpr std::array machine_options = {"--processor", "--memory", "--memorycycles"};
constexpr std::array occam_options = {"--mode", "--no-checks"};

/// Returns the reason why a text is not the size of a memory. Returns "" if the text is a valid size.
std::string not_a_size(const std::string& text) {
    const std::optional<std::uint64_t> size = bytes_of_size(text);
    if (!size)
        return fmt::format("\"{}\" is not a size such as 32K or 2M", text);
    const std::uint64_t bytes = *size;
    if (bytes < 2048 || bytes > 0xffff'ff00 || bytes % 256 != 0)
        return fmt::format(
            "{}: a processor that executes code needs 2K to just below 4096M of memory, in steps of 256 bytes", text);
    return "";
}

std::string not_memory_cycles(const std::string& text) {
    const std::optional<std::uint64_t> cycles = parse_number<std::uint64_t>(text);
    return cycles && *cycles >= 1 && *cycles <= 1000 ? "" : fmt::format("{}: expected 1 to 1000 cycles", text);
}

/// Returns the character that a letter after a backslash means. Returns nullopt if the letter has no such meaning.
std::optional<char> escaped(char letter) {
    switch (letter) {
    case 'r': return '\r';
    case 'n': return '\n';
    case 't': return '\t';
    case 'e': return '\x1b';
    case '\\': return '\\';
    default: return std::nullopt;
    }
}

std::string keys_of(const std::string& typed) {
    std::string keys;
    for (std::size_t i = 0; i < typed.size(); ++i) {
        if (typed[i] != '\\') {
            keys += typed[i];
            continue;
        }
        const std::optional<char> meant = i + 1 < typed.size() ? escaped(typed[++i]) : std::nullopt;
        if (!meant)
            throw UserError("--keys: \\ must be followed by r (the return key), n, t, e (the escape key) or \\");
        keys += *meant;
    }
    return keys;
}

/// Returns whether a file is empty, and has the name of a bootable file.
bool is_empty_program(const std::filesystem::path& file) {
    constexpr std::array endings = {".btl", ".b4h", ".b8h", ".bah", ".bxx"};
    std::error_code error;
    return std::ranges::find(endings, file.extension().string()) != endings.end() &&
           std::filesystem::is_regular_file(file, error) && std::filesystem::is_empty(file, error);
}

[[noreturn]] void refuse_program_argument(const std::string& argument) {
    const bool sets = argument.find('=') != std::string::npos;
    throw UserError(fmt::format("run takes no further argument: \"{}\"{}", argument,
                                sets ? "; a value of the netlist is set by --set " + argument : ""));
}

void refuse_for_netlists(const Options& typed, const NetlistOptions& netlist, const BootedOptions& options,
                         const Network& network) {
    for (const char* option : machine_options)
        if (typed.is_given(option))
            throw UserError(fmt::format(
                "{}: only a bootable file or a program in occam can be run with this option, but {} is a "
                "{}, which states its processors itself",
                option, netlist.file,
                occam::is_configuration(std::filesystem::path(netlist.file)) ? "configuration" : "netlist"));
    const bool has_code = std::ranges::any_of(network.nodes, [](const Node& node) { return node.image != nullptr; });
    for (const char* option : occam_options)
        if (typed.is_given(option) && !has_code)
            throw UserError(
                fmt::format("{}: no process of {} is in occam, so this option has no effect", option, netlist.file));
    if (has_bootable_file(network))
        return;
    if (!options.arguments.empty())
        refuse_program_argument(options.arguments.front());
    for (const char* option : {"--host-folder", "--keys", "--env", "--host-limit"})
        if (typed.is_given(option))
            throw UserError(fmt::format("{}: the netlist boots no transputer, so this option has no effect", option));
}

} // namespace

HostServices services_of(const BootedOptions& options) {
    HostServices host;
    host.folder = options.folder;
    host.command_line = fmt::format("{}", fmt::join(options.arguments, " "));
    for (const auto& [name, value] : overrides_of(options.environment, "--env", "ISEARCH=libs/"))
        host.environment.emplace(name, value);
    host.write_limit_bytes = std::min(options.write_limit_megabytes, std::uint64_t{1} << 43) << 20;
    return host;
}

void add_host(Options& command, BootedOptions& options, const std::string& heading) {
    command.add("ARGUMENTS", options.arguments, "words after --, which are the command line of the booted program");
    add_file(command, "--host-folder", options.folder, "the only folder whose files the program can use")
        .group(heading);
    command.add("--keys", options.keys, "the keys that are pressed for the program; \\r is the return key")
        .type("KEYS")
        .group(heading);
    command.add_list("--env", options.environment, "NAME=VALUE", "an environment variable that the program can read")
        .group(heading);
    add_count(command, "--host-limit", options.write_limit_megabytes, "Mbyte that the program can write to files")
        .show_default()
        .group(heading);
}

void add_machine(Options& command, BootedOptions& options, const std::string& heading) {
    std::vector<std::string> models;
    for (const transputer::Traits& each : transputer::all_traits)
        models.emplace_back(each.name);
    command.add("--processor", options.processor, "type of the transputer that a bootable file boots")
        .one_of(models)
        .show_default()
        .group(heading);
    command.add("--memory", options.memory, "memory of this transputer")
        .type("SIZE")
        .check(not_a_size)
        .show_default()
        .group(heading);
    add_count(command, "--memorycycles", options.memory_cycles,
              "number of cycles that an access to this transputer's external memory takes")
        .check(not_memory_cycles)
        .show_default()
        .group(heading);
}

void add_booted(Options& command, BootedOptions& options) {
    const std::string heading = "Transputers that execute their own code";
    add_machine(command, options, heading);
    add_host(command, options, heading);
    add_occam(command, options.occam);
}

std::function<std::shared_ptr<iserver::Terminal>()> terminal_for(const BootedOptions& options,
                                                                 std::function<bool()> interrupted,
                                                                 std::function<void()> unread,
                                                                 bool uses_standard_input) {
    if (!options.keys && uses_standard_input)
        return [interrupted, unread] { return std::make_shared<iserver::Console>(interrupted, 0, unread); };
    return [unread, keys = keys_of(options.keys.value_or(""))] {
        return std::make_shared<iserver::ScriptedTerminal>(keys, [unread](std::string_view text) {
            if (!iserver::write_to_screen(text))
                unread();
        });
    };
}

Network load_network(const Options& typed, const NetlistOptions& netlist, const BootedOptions& options) {
    const bool occam = is_occam(netlist.file);
    const bool bootable =
        occam || (netlist.file != "-" && (looks_bootable(netlist.file) || is_empty_program(netlist.file)));
    ReadOptions read = read_options_of(netlist.read);
    read.make_netlist = netlist_maker(options);
    if (bootable && !occam)
        read_bootable(netlist.file); // refuses a wrong file with a message that names only the file
    const ParsedNetlist parsed = bootable && !occam
                                     ? ParsedNetlist::of_text(netlist_around(netlist.file, options), netlist.file, read)
                                     : ParsedNetlist(netlist.file, read);
    const ProblemRegistry problems = known_problems(0);
    const Catalogue kinds = known_kinds(problems);
    if (!bootable)
        kinds.files()->choose(choices_of(options.occam));
    Network network = load_network(parsed, overrides_of(netlist.set), kinds, netlist.warn);
    if (!bootable)
        refuse_for_netlists(typed, netlist, options, network);
    network.host = services_of(options);
    return network;
}

} // namespace placedpar
