#include "app/options/netlist_options.hpp"

#include "app/standard_error.hpp"
#include "text/user_error.hpp"
#include "workbench/load.hpp"
#include "workbench/problems.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace placedpar {

CLI::Option* add_set(CLI::App& command, std::vector<std::string>& settings, const std::string& about) {
    return command.add_option("--set", settings, "NAME=VALUE: " + about)
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

Overrides overrides_of(std::span<const std::string> settings) {
    Overrides overrides;
    for (const std::string& each : settings) {
        std::size_t equals = each.find('=');
        if (equals == std::string::npos || equals == 0)
            throw UserError(fmt::format("--set {}: it takes NAME=VALUE, such as --set slaves=3", each));
        if (!overrides.emplace(each.substr(0, equals), each.substr(equals + 1)).second)
            throw UserError(fmt::format("--set {}: {} is set twice", each, each.substr(0, equals)));
    }
    return overrides;
}

void add_netlist(CLI::App& command, NetlistOptions& options) {
    command.add_option("FILE", options.file, "the netlist")->required();
    add_set(command, options.set, "gives a val of the netlist another value");
}

Network load_network(const NetlistOptions& options) {
    return load_network(options.file, overrides_of(options.set), known_problems(0), print_warnings);
}

} // namespace placedpar
