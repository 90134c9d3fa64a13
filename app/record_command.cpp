#include "app/record_command.hpp"

#include "app/common_options.hpp"
#include "app/output_file.hpp"
#include "app/overrides.hpp"
#include "app/scenario_record.hpp"
#include "app/standard_output.hpp"
#include "app/text_file.hpp"
#include "hydraulics/record_table.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
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

ExitCode record(const Options& options) {
    if (!options.out.empty()) {
        const std::filesystem::path output[] = {options.out};
        require_apart(output, options.machine);
        require_writable(options.out);
    }
    const RecordScenario& scenario = scenario_called(options.scenario);
    Parameters parameters =
        scenario_parameters(scenario, load_machine(options.machine), options.noise, overrides_of(options.set));
    std::string text = options.list ? list_parameters(scenario, parameters)
                                    : print_record(scenario_record(scenario, parameters, options.seed));
    if (options.out.empty())
        print_out(text);
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
    auto* command = app.add_subcommand("record", "Simulates a motion of the boom and writes what its sensors say");
    declare_options(*command, *options);
    command->callback([&chosen, options] { chosen = [options] { return record(*options); }; });
}

} // namespace placedpar
