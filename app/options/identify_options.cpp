#include "app/options/identify_options.hpp"

#include "app/options/common_options.hpp"
#include "app/options/link_options.hpp"

namespace placedpar {

using namespace hydraulics;

namespace {

constexpr std::uint64_t a_million = 1'000'000;

void declare_question(Options& command, IdentifyOptions& options) {
    command.add("RECORD", options.record, "measurements: comma-separated values, units in the header")
        .type("FILE")
        .required();
    add_links(command, options.links,
              "whose compliance: bucket, boom, stick, swing, or several with commas; all that the record has readings "
              "of if not given, and with --way thesis boom");
    add_configuration(command, options.configuration, "of the main valve as the record was taken").show_default();
    add_file(command, "--machine", options.machine, "constants that differ from those of placedpar parameters");
    command
        .add("--areas-from", options.areas,
             "the orifices' areas as they were read, by the spool, or by the servo-valve's voltage; the first of them "
             "that the record has if not given")
        .one_of({"areas", "spool", "servo"});
    command
        .add("--offset", options.offset,
             "by which the boom's spool reads too high, in; none if not given. With --way thesis also auto, "
             "which finds it in the record's steady motion, as it does there if not given")
        .type("auto|none|INCHES");
    command
        .add("--missing", options.missing,
             "what to do with a row that lacks a reading: refuse the record, or leave the row out")
        .one_of({"refuse", "skip"})
        .show_default();
}

void declare_way(Options& command, IdentifyOptions& options) {
    command
        .add("--way", options.way,
             "service: all movements of the record, as placedpar monitor identifies and judges them; thesis: one "
             "search over the first transient, as chapter 3 describes it; whole: one search for several links over the "
             "whole movement, with the missing flows weighed by their scatter")
        .one_of({"service", "thesis", "whole"})
        .show_default();
    // With fewer bits the compliance of a sound machine is within about a step of the lower bound.
    add_number(command, "--bits", options.bits, 6, 52, "of a compliance; 10 if not given, with --way whole 12");
    add_number(command, "--elite", options.elite, 0, a_million,
               "best individuals that go over unchanged; the way's own if not given");
    add_number(command, "--population", options.population, 2, a_million,
               "individuals; 120 if not given, with --way whole 120 to 600");
    add_number(command, "--trials", options.trials, 1, a_million,
               "generations for each new sample, 5 if not given; with --way whole for each of its rounds, 20 to 80");
    add_number(command, "--window", options.window, 1, 1024,
               "samples that a fitness is summed over; 10 if not given, with --way whole all");
    command.add("--bias", options.bias, "B of equation 3.9, (in^3/s)^2").type("NUMBER").show_default();
    add_seed(command, options.seed);
}

/// Declares the options of the other ways; the thesis's also applies to the simulated processes that search like it.
void declare_thesis_way(Options& command, IdentifyOptions& options) {
    const char* group = "With --way thesis or whole";
    add_number(command, "--samples", options.samples, 1, a_million,
               "that are used, from the valve's opening on; 20 if not given, the thesis's 0.4 s; with "
               "--way whole all up to 1,024 on the inlet side")
        .group(group);
    command
        .add("--side", options.side,
             "of the boom's cylinder: inlet, C_i from the pump's flow; outlet, C_o from the flow to the tank, which "
             "needs outlet_pressure (equation 3.4) and is searched for by --way whole unless --way thesis is given")
        .one_of({"inlet", "outlet"})
        .show_default()
        .group(group);
    command.add_flag("--rising", options.rising, "uses nothing from the first falling pressure on (thesis)")
        .group(group);
    command.add("--coding", options.coding, "of the bits; natural if not given, with --way whole gray")
        .one_of({"natural", "gray"})
        .group(group);
    Option netlist = add_file(
        command, "--on", options.netlist,
        "searches as the processes of this netlist, too (thesis); exit code 3 if they do not find the same", "NETLIST");
    netlist.group(group);
    command.add_list("--set", options.set, "NAME=VALUE", "sets a val, an attribute or a parameter of that netlist")
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
    add_file(command, "--json", options.json, "writes the result for machines");
    command.add_flag("--strict", options.strict,
                     "exit code 3 where an answer should not be believed as it stands, or an alarm holds");
    command.add_footer(
        "It prints, for each movement, the compliance of each link and the standard error that the record's own noise\n"
        "leaves, in both systems of units, and at the end what is said of each link: sound, or what is off by how "
        "much.\n"
        "A line with ! says where a compliance should not be believed as it stands. A record may have any length, and "
        "come\n"
        "through a pipe (\"-\" is standard input).\n"
        "What a record looks like: docs/guides/records.md. Records to try: examples/hydraulics/records. (Installed: "
        "share/doc/placedpar.)");
}

} // namespace placedpar
