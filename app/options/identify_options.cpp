#include "app/options/identify_options.hpp"

#include "app/options/common_options.hpp"
#include "app/options/link_options.hpp"

namespace placedpar {

using namespace hydraulics;

namespace {

constexpr std::uint64_t a_million = IdentifySettings::a_million;

void declare_question(Options& command, IdentifyOptions& options) {
    command
        .add("RECORD", options.records,
             "the measurements: comma-separated values with units in the header; several records give a trend")
        .type("FILE")
        .required();
    command.add_list("--column", options.columns, "NAME=NAME_IN_FILE",
                     "name of a column in the record, such as boom.inlet_pressure=P_boom_in, \"angle [deg]=Phi 1\" or "
                     "time=Timestamp; a name without a link means the boom");
    add_file(command, "--columns-from", options.columns_from, "file with column names, one on each line");
    add_links(command, options.links,
              "links to identify, separated by commas: bucket, boom, stick, swing; default: every link with readings; "
              "with --way thesis or whole: boom");
    add_configuration(command, options.configuration,
                      "configuration of the main valve during the record; default: recognised sample by sample if the "
                      "record has pressure, angle and areas of all links, otherwise configuration a");
    add_file(command, "--machine", options.machine,
             "file with constants that replace those that \"placedpar parameters\" prints");
    command
        .add("--areas-from", options.areas,
             "source of the orifices' areas: read directly, computed from the spool, or computed from the "
             "servo-valve's voltage; default: the first of the three that the record has")
        .one_of({"areas", "spool", "servo"});
    command
        .add("--offset", options.offset,
             "offset by which the readings of the boom's spool are too high, in inches; default: none. With --way "
             "thesis or whole the default is auto, which finds the offset in the record's steady motion")
        .type("auto|none|INCHES");
    command
        .add("--missing", options.missing,
             "what to do with a row that lacks a reading: refuse the record, or skip the row")
        .one_of({"refuse", "skip"})
        .show_default();
}

void declare_way(Options& command, IdentifyOptions& options) {
    command
        .add("--way", options.way,
             "service: identifies and judges every movement, as placedpar monitor does; thesis: one search over "
             "the first transient, as in chapter 3; whole: one search for several links over the whole movement, "
             "which divides each link's flow error by its scatter; default: service, or whole with --side outlet")
        .one_of({"service", "thesis", "whole"});
    // With fewer bits than least_bits, a step of the code would be about as large as the compliance of a sound machine.
    add_number(command, "--bits", options.bits, IdentifySettings::least_bits, IdentifySettings::most_bits,
               "number of bits that code a compliance; default: 10, or 12 with --way whole");
    add_number(command, "--elite", options.elite, 0, a_million,
               "number of best individuals that survive unchanged; default: depends on --way");
    add_number(command, "--population", options.population, 2, a_million,
               "number of individuals; default: 120, or 120 to 600 with --way whole");
    add_number(
        command, "--trials", options.trials, 1, a_million,
        "number of generations for each new sample, default: 5; with --way whole for each round, default: 20 to 80");
    add_number(command, "--window", options.window, 1, IdentifySettings::most_window,
               "number of samples that the fitness sums over; default: 10, or all samples with --way whole");
    command.add("--bias", options.bias, "bias B of the fitness (equation 3.9 of the thesis), in (in^3/s)^2")
        .type("NUMBER")
        .show_default();
    add_seed(command, options.seed);
}

/// Declares the options of `--way thesis` and `--way whole`. The options of `--way thesis` also apply to `--on`.
void declare_thesis_way(Options& command, IdentifyOptions& options) {
    const char* group = "With --way thesis or whole";
    add_number(command, "--samples", options.samples, 1, a_million,
               "number of samples to use, from the valve's opening on; default: 20, the thesis's 0.4 s; with "
               "--way whole all samples, but at most 1,024 on the inlet side")
        .group(group);
    command
        .add("--side", options.side,
             "side of the boom's cylinder: inlet identifies C_i from the pump's flow; outlet identifies C_o from the "
             "flow to the tank, and needs outlet_pressure (equation 3.4)")
        .one_of({"inlet", "outlet"})
        .show_default()
        .group(group);
    command.add_flag("--rising", options.rising, "with --way thesis: uses only samples before the pressure first falls")
        .group(group);
    command
        .add("--coding", options.coding, "coding of a compliance as bits; default: natural, or gray with --way whole")
        .one_of({"natural", "gray"})
        .group(group);
    Option netlist = add_file(
        command, "--on", options.netlist,
        "with --way thesis: also runs the search as the processes of this netlist, one search or several islands; "
        "exit code 3 if a single search gives another answer",
        "NETLIST");
    netlist.group(group);
    command.add_list("--set", options.set, "NAME=VALUE", "sets a val, an attribute or a parameter of the netlist")
        .needs(netlist)
        .group(group);
    for (Option option : add_read_options(command, options.read))
        option.needs(netlist).group(group);
}

} // namespace

void declare_identify_options(Options& command, IdentifyOptions& options) {
    declare_question(command, options);
    declare_way(command, options);
    declare_thesis_way(command, options);
    add_file(command, "--trend", options.trend,
             "with several records: draws each link's compliance over the records' dates as SVG", "FILE.svg");
    add_file(command, "--json", options.json, "writes the result as JSON");
    command.add_flag("--strict", options.strict,
                     "exit code 3 if an answer is flagged as doubtful or an alarm is raised; with several records, "
                     "if a change is found or a record has no answer");
    command.add_footer(
        "For each movement the command prints each link's compliance in both systems of units, with the standard "
        "error that\nthe record's noise causes. At the end it judges each link: sound, or which fault it has and how "
        "large.\nA line with ! marks a doubtful compliance. A record may have any length and come "
        "through a pipe (\"-\" is standard input).\nFormat of records: docs/guides/records.md. Records to try: "
        "examples/hydraulics/records. After an installation, both are in share/doc/placedpar.");
}

} // namespace placedpar
