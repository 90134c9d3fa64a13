#include "app/record_command.hpp"

#include "app/common_options.hpp"
#include "app/link_options.hpp"
#include "hydraulics/data/record_table.hpp"
#include "text/output_file.hpp"
#include "text/standard_output.hpp"
#include "workbench/overrides.hpp"
#include "workbench/scenario_record.hpp"
#include "workbench/text_file.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace placedpar {

using namespace hydraulics;

namespace {

/// What the command line may say.
struct Options {
    std::string scenario, links, configuration, noise, machine, out;
    std::vector<std::string> set;
    std::uint64_t seed = 1;
    bool list = false;
};

LinksInMotion moving_of(const Options& options, const RecordScenario& scenario) {
    if (!scenario.any_links && !(options.links.empty() && options.configuration.empty()))
        throw std::runtime_error(fmt::format("--{}: {} has links and a configuration of its own; the scenario links "
                                             "takes any",
                                             options.links.empty() ? "configuration" : "link", scenario.name));
    return {options.configuration.empty() ? Configuration::a : *configuration_named(options.configuration),
            links_of(options.links.empty() ? "bucket,boom" : options.links)};
}

ExitCode record(const Options& options) {
    if (!options.out.empty()) {
        const std::filesystem::path output[] = {options.out};
        require_apart(output, options.machine);
        require_writable(options.out);
    }
    const RecordScenario& scenario = scenario_called(options.scenario);
    LinksInMotion moving = moving_of(options, scenario);
    Parameters parameters =
        scenario_parameters(scenario, load_machine(options.machine), options.noise, overrides_of(options.set));
    std::string text = options.list ? list_parameters(scenario, parameters)
                                    : print_record(scenario_record(scenario, moving, parameters, options.seed));
    if (options.out.empty())
        print_out(text);
    else
        write_whole(options.out, text);
    return ExitCode::success;
}

void declare_options(CLI::App& command, Options& options) {
    command.add_option("SCENARIO", options.scenario, "one of those below")->required();
    add_links(command, options.links, "that move in the scenario links: bucket,boom if not given");
    add_configuration(command, options.configuration, "of the main valve in the scenario links: a if not given");
    command.add_option("--set", options.set, "NAME=VALUE: gives a parameter another value, perhaps with its unit")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    command.add_option("--noise", options.noise, "of the sensors: none, low, mid or high")->type_name("LEVEL");
    add_file(command, "--machine", options.machine, "constants that differ from those of placedpar parameters");
    add_seed(command, options.seed, "of the sensors' noise");
    add_file(command, "--out", options.out, "writes the record there, not to standard output");
    command.add_flag("--list", options.list,
                     "lists the scenario's parameters instead: name, value, unit, mark, source");
    command.footer("scenarios:\n" + list_record_scenarios());
}

} // namespace

void declare_record(CLI::App& app, ChosenCommand& chosen) {
    auto options = std::make_shared<Options>();
    auto* command = app.add_subcommand("record", "Simulates a motion of the machine and writes what its sensors say");
    declare_options(*command, *options);
    command->callback([&chosen, options] { chosen = [options] { return record(*options); }; });
}

} // namespace placedpar
