#include "app/command.hpp"
#include "app/options/common_options.hpp"
#include "app/options/link_options.hpp"
#include "app/options/netlist_options.hpp"
#include "app/record/dig_job_file.hpp"
#include "app/record/scenario_record.hpp"
#include "app/standard_error.hpp"
#include "explore/identify/question.hpp"
#include "explore/load.hpp"
#include "hydraulics/data/record_table.hpp"
#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

using namespace hydraulics;

namespace {

struct RecordOptions {
    std::string scenario, job, links, configuration, noise, machine, out;
    std::vector<std::string> set;
    std::uint64_t seed = 1;
    bool list = false;
};

LinksInMotion moving_of(const RecordOptions& options, const RecordScenario& scenario) {
    if (!scenario.any_links && !(options.links.empty() && options.configuration.empty()))
        throw UserError(fmt::format("--{}: the scenario \"{}\" has fixed links and a fixed configuration; use the "
                                    "scenario \"links\" to choose them",
                                    options.links.empty() ? "configuration" : "link", scenario.name));
    return {options.configuration.empty() ? Configuration::a : *configuration_named(options.configuration),
            links_of(options.links.empty() ? "bucket,boom" : options.links)};
}

void require_output(const RecordOptions& options) {
    if (options.out.empty())
        return;
    const std::filesystem::path output[] = {options.out};
    for (const std::string& input : {options.machine, options.job})
        require_apart(output, input);
    require_writable(options.out);
}

const RecordScenario& scenario_of(const RecordOptions& options) {
    const RecordScenario& scenario = scenario_called(options.scenario);
    if (options.job.empty())
        return scenario;
    if (scenario.name != digging_scenario().name)
        throw UserError(fmt::format("--job {}: the scenario {} takes no job; the scenario {} does", options.job,
                                    scenario.name, digging_scenario().name));
    return digging_scenario();
}

/// Returns the output of the command: the record, or with --list the scenario's parameters.
std::string text_of(const RecordOptions& options) {
    const RecordScenario& scenario = scenario_of(options);
    LinksInMotion moving = moving_of(options, scenario);
    Parameters parameters = scenario_parameters(scenario, load_machine(options.machine, print_warnings), options.noise,
                                                overrides_of(options.set));
    std::optional<DigJob> job;
    if (!options.job.empty())
        moving.job = &job.emplace(load_dig_job(options.job, moving_excavator(parameters)));
    return options.list ? list_parameters(scenario, parameters)
                        : print_record(scenario_record(scenario, moving, parameters, options.seed));
}

ExitCode record(const RecordOptions& options) {
    require_output(options);
    std::string text = text_of(options);
    if (options.out.empty())
        print_out(text);
    else
        write_whole(options.out, text);
    return ExitCode::success;
}

void declare_options(Options& command, RecordOptions& options) {
    command.add("SCENARIO", options.scenario, "one of the scenarios below").required();
    add_file(command, "--job", options.job,
             "file of the operator's moves, for the scenario \"excavator\": all links dig, and the record's last "
             "column is the configuration of the main valve");
    add_links(command, options.links, "links that move, for the scenario \"links\"; default: bucket,boom");
    add_configuration(command, options.configuration,
                      "configuration of the main valve, for the scenario \"links\"; default: a");
    add_set(command, options.set, "sets a parameter, for example to .005 or \"4.1e-11 m^3/Pa\"");
    command.add("--noise", options.noise, "noise of the sensors: none, low, mid or high").type("LEVEL");
    add_file(command, "--machine", options.machine,
             "file with constants that replace those that \"placedpar parameters\" prints");
    add_seed(command, options.seed, "seed of the sensors' noise");
    add_file(command, "--out", options.out, "writes the record to this file; default: standard output");
    command.add_flag("--list", options.list,
                     "lists the scenario's parameters (name, value, unit, mark, source) and makes no record");
    command.add_footer("scenarios:\n" + list_record_scenarios());
}

Action declare_record(Options& command, const std::string&) {
    auto options = std::make_shared<RecordOptions>();
    declare_options(command, *options);
    return [options] { return record(*options); };
}

} // namespace

extern const Command record_command{
    .name = "record",
    .about = "Simulates a motion of the excavator and writes the readings of its sensors",
    .place = 80,
    .declare = declare_record,
    .values = names_of_scenarios,
};

} // namespace placedpar
