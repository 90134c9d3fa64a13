#include "app/identify_command.hpp"

#include "app/common_options.hpp"
#include "app/identification/identification_report.hpp"
#include "app/manifest.hpp"
#include "app/netlist_run.hpp"
#include "app/output_file.hpp"
#include "app/overrides.hpp"
#include "app/run_report.hpp"
#include "app/standard_output.hpp"
#include "app/text_file.hpp"
#include "gaprocs/search_problem.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace placedpar {

namespace {

/// What the command line may say.
struct Options {
    std::string record, links = "boom", configuration = "a", way = "thesis", offset = "auto", areas, coding, machine,
                        netlist, json;
    std::vector<std::string> set;
    std::uint64_t seed = 1;
    std::size_t bits = 10, population = 120, trials = 5, window = 10, samples = 20;
    double bias = 400;
    std::optional<std::size_t> elite;
    bool rising = false;
};

LinkSet links_of(const std::string& text) {
    LinkSet links;
    for (const std::string& name : CLI::detail::split(text, ',')) {
        auto link = link_named(name);
        if (!link)
            throw std::runtime_error(
                fmt::format("--link {}: there is no link \"{}\"; there are bucket, boom, stick and swing", text, name));
        links.insert(*link);
    }
    return links;
}

IdentificationWay way_of(const Options& options) {
    IdentificationWay way = options.way == "thesis" ? thesis_way() : service_way();
    way.bits = options.bits;
    if (auto coding = coding_named(options.coding))
        way.coding = *coding;
    way.search.elite = options.elite.value_or(way.search.elite);
    way.search.population = options.population;
    way.search.window.trials = options.trials;
    way.search.window.length = options.window;
    way.search.window.bias = options.bias;
    way.usable.count = options.samples;
    way.usable.rising = options.rising;
    way.search.validate();
    return way;
}

std::optional<AreasFrom> areas_of(const Options& options) {
    if (options.areas.empty())
        return std::nullopt;
    return options.areas == "spool" ? AreasFrom::spool : options.areas == "servo" ? AreasFrom::servo : AreasFrom::areas;
}

double inches_of(const std::string& text) {
    double inches = 0;
    auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), inches);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(inches))
        throw std::runtime_error(fmt::format("--offset {}: it takes auto, none, or a number of inches", text));
    return inches;
}

/// The offset that --offset asks for; says what came of "auto".
std::optional<double> spool_offset(const Options& options, const Record& record, const Parameters& machine) {
    if (options.offset == "none")
        return std::nullopt;
    if (options.offset != "auto")
        return inches_of(options.offset);
    if (!record.has(MachineLink::boom, Sensor::spool))
        return std::nullopt;
    auto found = calibrate_spool_offset(record, link_readings(machine), flow_constants(machine));
    if (found)
        print_out(fmt::format("spool offset: {:+.5f} in, standard error {:.5f}, from {} samples of steady motion\n",
                              found->offset_in, found->deviation_in, found->samples));
    else
        print_out("spool offset: not calibrated, for the record has no second of steady motion\n");
    return found ? std::optional(found->offset_in) : std::nullopt;
}

/// The record's problem takes the place of the program's own "boom".
ProblemRegistry problems_with(const RecordProblem& prepared) {
    std::vector<Sample> record;
    for (const CircuitSample& sample : prepared.samples)
        record.push_back(sample.values());
    ProblemRegistry problems;
    problems.add("boom", make_search_problem(prepared.problem), std::move(record));
    return problems;
}

/// Runs the identification as processes of a simulated machine, and says whether the answer is the native one.
ExitCode run_on_machine(const Network& network, const ProblemRegistry& problems, std::uint64_t seed,
                        const RecordProblem& prepared, const Identified& native) {
    RunReport report = run_netlist(network, problems, seed);
    print_out(fmt::format("\n{}\n", print_report(report, network)));
    if (report.result.ending != Ending::completed)
        return exit_code_of(report.result.ending);
    for (std::size_t j = 0; j < native.links.size(); ++j) {
        double here = native.estimates.back().compliance_in3_per_psi[j];
        double there = report.measured("master", prepared.problem.parameter_names()[j]);
        print_out(fmt::format("{}: {:.5f} in^3/psi natively, {:.5f} by the processes: {}\n",
                              prepared.problem.parameter_names()[j], here, there,
                              here == there ? "the same" : "not the same"));
    }
    return ExitCode::success;
}

/// The netlist of --on, if there is one.
std::optional<Network> network_of(const Options& options, const ProblemRegistry& problems) {
    if (options.netlist.empty())
        return std::nullopt;
    Network network = load_network(options.netlist, overrides_of(options.set), problems);
    const std::filesystem::path output[] = {options.json};
    for (const std::string& included : network.included_paths)
        require_apart(output, included);
    return network;
}

ExitCode identify_record(const Options& options, const std::string& command_line) {
    const std::filesystem::path output[] = {options.json};
    for (const std::string& input : {options.record, options.machine, options.netlist})
        require_apart(output, input);
    if (!options.json.empty())
        require_writable(options.json);
    Parameters machine = load_machine(options.machine);
    Record record = load_record(options.record);
    IdentificationWay way = way_of(options);
    Question question{*configuration_named(options.configuration), links_of(options.links),
                      spool_offset(options, record, machine), areas_of(options)};
    RecordProblem prepared = prepare(record, machine, question, way);
    ProblemRegistry problems = problems_with(prepared);
    std::optional<Network> network = network_of(options, problems);
    Identified identified = identify(prepared.problem, prepared.flow, prepared.samples, way, options.seed);
    print_out(print_identified(identified, prepared, way));
    if (!options.json.empty()) {
        boost::json::object json{{"version", version}, {"command", command_line}, {"seed", options.seed}};
        for (auto& [key, value] : identified_json(identified, prepared))
            json[key] = value;
        write_whole(options.json, print_pretty(json));
    }
    return network ? run_on_machine(*network, problems, options.seed, prepared, identified) : ExitCode::success;
}

void declare_options(CLI::App& command, Options& options) {
    command.add_option("RECORD", options.record, "measurements: comma-separated values, units in the header")
        ->required();
    command.add_option("--link", options.links, "bucket, boom, stick, swing; or several, coupled: bucket,boom")
        ->type_name("LINK[,LINK]")
        ->capture_default_str();
    command.add_option("--configuration", options.configuration, "of the main valve: a to e")
        ->check(CLI::IsMember({"a", "b", "c", "d", "e"}))
        ->capture_default_str();
    command
        .add_option(
            "--way", options.way,
            "thesis: as chapter 3 describes it; service: Gray code, an elite, a gate on excitation, the spool's "
            "offset calibrated, 21 searches")
        ->check(CLI::IsMember({"thesis", "service"}))
        ->capture_default_str();
    command.add_option("--offset", options.offset, "of the boom's spool: auto, none, or a number of inches")
        ->capture_default_str();
    command
        .add_option("--areas-from", options.areas,
                    "areas, spool or servo (experiments 1 and 2 of the thesis: the spool, the servo-valve's voltage)")
        ->check(CLI::IsMember({"areas", "spool", "servo"}));
    add_file(command, "--machine", options.machine, "constants that differ from those of placedpar parameters");
    command.add_option("--bits", options.bits, "of a compliance")->check(CLI::Range(1, 52))->capture_default_str();
    command.add_option("--coding", options.coding, "natural or gray; the way's own if not given")
        ->check(CLI::IsMember({"natural", "gray"}));
    command.add_option("--elite", options.elite, "best individuals that go over unchanged; the way's own if not given")
        ->check(not_a_whole_number);
    add_count(command, "--population", options.population, "individuals");
    add_count(command, "--trials", options.trials, "generations a sample");
    add_count(command, "--window", options.window, "samples that a fitness is summed over");
    command.add_option("--bias", options.bias, "B of equation 3.9, (in^3/s)^2")->capture_default_str();
    add_count(command, "--samples", options.samples, "usable samples from the valve's opening on: 20 are 0.4 s");
    command.add_flag("--rising", options.rising, "nothing from the first falling pressure on");
    add_seed(command, options.seed);
    add_file(command, "--on", options.netlist, "then runs it as the processes of this netlist, too", "NETLIST");
    command.add_option("--set", options.set, "NAME=VALUE: gives a val of that netlist another value")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    add_file(command, "--json", options.json, "writes the result for machines");
}

} // namespace

void declare_identify(CLI::App& app, ChosenCommand& chosen, const std::string& command_line) {
    auto options = std::make_shared<Options>();
    auto* command = app.add_subcommand("identify", "Finds the hydraulic compliances that a record of motion shows");
    declare_options(*command, *options);
    command->callback([&chosen, &command_line, options] {
        chosen = [&, options] { return identify_record(*options, command_line); };
    });
}

} // namespace placedpar
