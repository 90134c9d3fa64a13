#include "app/record_command.hpp"

#include "app/output_file.hpp"
#include "app/overrides.hpp"
#include "app/scenario_record.hpp"
#include "app/text_file.hpp"
#include "hydraulics/record_table.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace placedpar {

namespace {

/// What the command line may say.
struct Options {
    std::string scenario, noise, machine, out;
    std::vector<std::string> set;
    std::uint64_t seed = 1;
    bool list = false;
};

void write_to_standard_output(const std::string& text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw std::runtime_error("standard output cannot be written");
}

ExitCode record(const Options& options) {
    const RecordScenario& scenario = scenario_called(options.scenario);
    Parameters parameters =
        scenario_parameters(scenario, load_machine(options.machine), options.noise, overrides_of(options.set));
    if (!options.out.empty())
        require_writable(options.out);
    std::string text = options.list ? list_parameters(scenario, parameters)
                                    : print_record(scenario_record(scenario, parameters, options.seed));
    if (options.out.empty())
        write_to_standard_output(text);
    else
        write_whole(options.out, text);
    return ExitCode::success;
}

void declare_options(CLI::App& command, Options& options) {
    command.add_option("SCENARIO", options.scenario, "one of those below")->required();
    command.add_option("--set", options.set, "NAME=VALUE: gives a parameter another value, perhaps with its unit")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    command.add_option("--noise", options.noise, "of the sensors: none, low, mid or high")->type_name("LEVEL");
    command.add_option("--machine", options.machine, "constants that differ from those of placedpar parameters")
        ->type_name("FILE");
    command.add_option("--seed", options.seed, "of the sensors' noise")->type_name("N")->capture_default_str();
    command.add_option("--out", options.out, "writes the record there, not to standard output")->type_name("FILE");
    command.add_flag("--list", options.list,
                     "lists the scenario's parameters instead: name, value, unit, mark, source");
    command.footer("scenarios:\n" + list_record_scenarios());
}

} // namespace

void declare_record(CLI::App& app, ChosenCommand& chosen) {
    auto options = std::make_shared<Options>();
    auto* command = app.add_subcommand("record", "Simulates a motion of the boom and writes what its sensors say");
    declare_options(*command, *options);
    command->callback([&chosen, options] { chosen = [options] { return record(*options); }; });
}

} // namespace placedpar
