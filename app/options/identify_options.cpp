#include "app/options/identify_options.hpp"

#include "app/options/common_options.hpp"
#include "app/options/link_options.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace placedpar {

using namespace hydraulics;

namespace {

/// An option that takes one of a few words.
CLI::Option* add_choice(CLI::App& command, const char* name, std::string& value, const char* about,
                        const std::vector<std::string>& words) {
    return command.add_option(name, value, about)
        ->check(CLI::IsMember(words).description(""))
        ->type_name(fmt::format("{}", fmt::join(words, "|")));
}

constexpr std::uint64_t a_million = 1'000'000;

void declare_question(CLI::App& command, IdentifyOptions& options) {
    command.add_option("RECORD", options.record, "measurements: comma-separated values, units in the header")
        ->type_name("FILE")
        ->required();
    add_links(command, options.links,
              "whose compliance: bucket, boom, stick, swing; or of several that share a pump: bucket,boom")
        ->capture_default_str();
    add_configuration(command, options.configuration, "of the main valve as the record was taken")
        ->capture_default_str();
    add_file(command, "--machine", options.machine, "constants that differ from those of placedpar parameters");
    add_choice(
        command, "--areas-from", options.areas,
        "the orifices' areas as they were read, by the spool, or by the servo-valve's voltage; the first of them "
        "that the record has if not given",
        {"areas", "spool", "servo"});
    command
        .add_option("--offset", options.offset,
                    "by which the boom's spool reads too high; auto finds it in the record's steady motion")
        ->type_name("auto|none|INCHES")
        ->capture_default_str();
    add_number(command, "--samples", options.samples, 1, a_million,
               "that are used, from the valve's opening on: 20 are the thesis's 0.4 s")
        ->capture_default_str();
    command.add_flag("--rising", options.rising, "uses nothing from the first falling pressure on");
}

void declare_way(CLI::App& command, IdentifyOptions& options) {
    add_choice(command, "--way", options.way,
               "thesis: one search, as chapter 3 describes it; service: 21 searches in Gray code with an elite, which "
               "rest while the pressure hardly moves",
               {"thesis", "service"})
        ->capture_default_str();
    // With fewer bits the compliance of a sound machine is within a step or so of the lower bound.
    add_number(command, "--bits", options.bits, 6, 52, "of a compliance")->capture_default_str();
    add_choice(command, "--coding", options.coding, "of the bits; the way's own if not given", {"natural", "gray"});
    add_number(command, "--elite", options.elite, 0, a_million,
               "best individuals that go over unchanged; the way's own if not given");
    add_number(command, "--population", options.population, 2, a_million, "individuals")->capture_default_str();
    add_number(command, "--trials", options.trials, 1, a_million, "generations for each new sample")
        ->capture_default_str();
    add_number(command, "--window", options.window, 1, 1024, "samples that a fitness is summed over")
        ->capture_default_str();
    command.add_option("--bias", options.bias, "B of equation 3.9, (in^3/s)^2")
        ->type_name("NUMBER")
        ->capture_default_str();
    add_seed(command, options.seed);
}

} // namespace

void declare_identify_options(CLI::App& command, IdentifyOptions& options) {
    declare_question(command, options);
    declare_way(command, options);
    auto* netlist =
        add_file(command, "--on", options.netlist,
                 "searches as the processes of this netlist, too; exit code 3 if they do not find the same", "NETLIST");
    command.add_option("--set", options.set, "sets a val, an attribute or a parameter of that netlist")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false)
        ->needs(netlist);
    for (auto* option : add_read_options(command, options.read))
        option->needs(netlist);
    add_file(command, "--json", options.json, "writes the result for machines");
    command.add_flag("--strict", options.strict, "exit code 3 where an answer should not be believed as it stands");
    command.footer(
        "It prints the compliance of each link (the median of the searches) and the standard error that the record's "
        "own noise leaves,\n"
        "in both systems of units; the best of all codes on the last window, in in^3/psi, and how many codes the "
        "searches end from it.\n"
        "A line with ! says where that should not be believed as it stands. --json has where 90 % of the searches end, "
        "too.\n"
        "What a record looks like: docs/records.md. Records to try: examples/records.");
}

} // namespace placedpar
