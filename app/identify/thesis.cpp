#include "app/identify/ways.hpp"

#include "app/identify/on_machine.hpp"
#include "app/identify/question.hpp"
#include "app/options/link_options.hpp"
#include "app/options/netlist_options.hpp"
#include "app/standard_error.hpp"
#include "explore/load.hpp"
#include "explore/process_search.hpp"
#include "identification/flags.hpp"
#include "identification/report/identification_report.hpp"
#include "identification/whole_search.hpp"
#include "text/counted.hpp"
#include "text/output_file.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// Returns the way, changed by the options that were typed.
IdentificationWay way_of(const IdentifyOptions& options, IdentificationWay way) {
    way.bits = options.bits.value_or(way.bits);
    if (!options.coding.empty())
        way.coding = Coding::named(options.coding);
    way.search.elite = options.elite.value_or(way.search.elite);
    way.search.population = options.population.value_or(way.search.population);
    way.search.window.trials = options.trials.value_or(way.search.window.trials);
    way.search.window.length = options.window.value_or(way.search.window.length);
    way.search.window.bias = options.bias;
    way.usable.count = options.samples.value_or(way.usable.count);
    way.usable.rising = options.rising;
    way.search.validate();
    if (std::size_t needed = samples_for_first_generation(way); way.usable.count < needed)
        throw UserError(fmt::format("--samples {}: expected at least {}, which the first generation needs",
                                    way.usable.count, needed));
    return way;
}

/// Returns whether the boom's areas come from the position of its spool, which is read or computed from the voltage by
/// equation A.1.
bool uses_spool(const Record& record, const Question& question) {
    return question.links.contains(Link::boom) &&
           areas_from(record.channels(), Link::boom, question.areas_from) != AreasFrom::areas;
}

/// A record and the question about it.
struct Case {
    Parameters machine;
    LoadedRecord loaded;
    Sampling sampling; ///< sampling of the record as read
    IdentificationWay way;
    Question question;
    bool calibrates = false;                ///< the offset is calibrated from the record (`--offset auto`, the default)
    std::optional<SpoolOffset> calibration; ///< set if the calibration found the offset
};

std::string print_calibration(const std::optional<SpoolOffset>& found) {
    if (!found)
        return "spool offset: not calibrated, because the record has no second of steady motion\n";
    return fmt::format("spool offset: {:+.5f} in, standard error {:.5f}, from {} samples of steady motion\n",
                       found->offset_in, found->deviation_in, found->samples);
}

/// Calibrates the offset from the record's own steady motion.
void calibrate(Case& asked) {
    asked.calibrates = asked.loaded.record.has(Link::boom, Sensor::spool) &&
                       asked.loaded.record.has(Link::boom, Sensor::inlet_pressure);
    if (asked.calibrates)
        asked.calibration = calibrate_spool_offset(asked.loaded.record, link_calibrations(asked.machine),
                                                   flow_constants(asked.machine));
    if (asked.calibration)
        asked.question.spool_offset_in = asked.calibration->offset_in;
}

LinkSet links_asked(const IdentifyOptions& options) {
    return options.links.empty() ? LinkSet{Link::boom} : links_of(options.links);
}

Case read_case(const IdentifyOptions& options, const IdentificationWay& way) {
    Case asked;
    asked.way = way_of(options, way);
    const LinkSet links = links_asked(options);
    asked.question = {*configuration_named(options.configuration), links, std::nullopt, areas_asked(options),
                      side_asked(options)};
    bool automatic = options.offset.empty() || options.offset == "auto";
    if (!automatic && options.offset != "none")
        asked.question.spool_offset_in = offset_asked(options.offset);
    asked.machine = load_machine(options.machine, print_warnings);
    asked.loaded =
        load_record(options.record, needs_of(options, [links](const ChannelSet&) { return links; }), print_warnings);
    asked.sampling = Sampling::of(asked.loaded.record.period_s);
    if (asked.sampling.readings > 1)
        asked.loaded.record = averaged(asked.loaded.record, asked.sampling);
    if (!uses_spool(asked.loaded.record, asked.question)) {
        if (asked.question.spool_offset_in)
            throw UserError(fmt::format("--offset {}: the option has no effect, because no area is computed from "
                                        "the boom's spool",
                                        options.offset));
    } else if (automatic) {
        calibrate(asked);
    }
    return asked;
}

/// Prints the settings of a search over the whole movement, the least standard error that the record's noise allows,
/// and the cost.
std::string print_whole(const Identified& identified, const ComplianceSearch& prepared, const WholeWay& whole,
                        const SearchCost& cost) {
    std::string text = fmt::format(
        "\nsettings for {}: {} rounds of {}, {} for each compliance in {} code, an elite of {}\nafter each round, each "
        "link's flow error is divided by its scatter at the best individual\nleast possible standard error with the "
        "noise of these samples (Cramer-Rao bound):",
        counted(identified.links.size(), "link"), whole.rounds, counted(whole.way.search.window.trials, "generation"),
        counted(whole.way.bits, "bit"), whole.way.coding == Coding::gray ? "Gray" : "natural", whole.way.search.elite);
    for (const LinkIdentified& link : identified.links)
        text += fmt::format("{} {} {:.1f} %", &link == &identified.links.front() ? "" : ",", name_of(link.link),
                            100 * link.standard_error / link.compliance_in3_per_psi);
    return text + fmt::format("\ncost: {:.0f} individuals, each evaluated at {}; this takes {:.0f} s on one T800 of 20 "
                              "MHz, {:.0f} s on 16 T800s\n",
                              cost.individuals, counted(prepared.samples.size(), "sample"), cost.seconds,
                              cost.seconds_on_16);
}

boost::json::object cost_json(const SearchCost& cost) {
    return {{"individuals", cost.individuals},
            {"errors", cost.errors},
            {"t800_s", cost.seconds},
            {"t800_16_s", cost.seconds_on_16}};
}

} // namespace

ExitCode identify_over_whole(const IdentifyOptions& options, boost::json::object& json) {
    WholeWay whole = whole_way(links_asked(options).size(), side_asked(options));
    const Case asked = read_case(options, whole.way);
    whole.way = asked.way;
    json["warnings"] = warnings_json(asked.loaded.warnings);
    json["sampling"] = sampling_json(asked.sampling);
    const ComplianceSearch prepared = prepare(asked.loaded.record, asked.machine, asked.question, whole.way);
    Identified identified = identify_whole(prepared, whole, options.seed);
    flag_spikes(identified, asked.loaded.record, prepared.samples);
    if (asked.calibration)
        flag_calibration(identified, *asked.calibration, spool_sensor_step_in(asked.machine));
    if (asked.sampling.readings > 1)
        print_out(print_sampling(asked.sampling) + "\n");
    if (asked.calibrates)
        print_out(print_calibration(asked.calibration));
    const SearchCost cost = cost_of(whole, prepared.problem, identified.generations, prepared.samples.size());
    print_out(print_identified(identified, prepared, whole.way) + print_whole(identified, prepared, whole, cost));
    for (auto& [key, value] : identified_json(identified, prepared))
        json[key] = value;
    json["cost"] = cost_json(cost);
    return options.strict && identified.flagged() ? ExitCode::missed_tolerance : ExitCode::success;
}

ExitCode identify_by_thesis(const IdentifyOptions& options, boost::json::object& json) {
    const Case asked = read_case(options, thesis_way());
    json["warnings"] = warnings_json(asked.loaded.warnings);
    json["sampling"] = sampling_json(asked.sampling);
    identification::ComplianceSearch prepared = prepare(asked.loaded.record, asked.machine, asked.question, asked.way);
    Identified identified = identify(prepared.problem, prepared.flow, prepared.samples, asked.way, options.seed);
    flag_spikes(identified, asked.loaded.record, prepared.samples);
    if (asked.calibration)
        flag_calibration(identified, *asked.calibration, spool_sensor_step_in(asked.machine));
    std::optional<ProcessSearch> processes;
    if (!options.netlist.empty())
        processes = search_by_processes({options.netlist, overrides_of(options.set),
                                         ParsedNetlist(options.netlist, read_options_of(options.read)), options.json},
                                        prepared, asked.way, print_warnings);
    if (asked.sampling.readings > 1)
        print_out(print_sampling(asked.sampling) + "\n");
    if (asked.calibrates)
        print_out(print_calibration(asked.calibration));
    print_out(print_identified(identified, prepared, asked.way));
    for (auto& [key, value] : identified_json(identified, prepared))
        json[key] = value;
    ExitCode ended =
        processes ? run_on_machine(*processes, identified, prepared, options.seed, json) : ExitCode::success;
    bool doubted = options.strict && identified.flagged();
    return ended == ExitCode::success && doubted ? ExitCode::missed_tolerance : ended;
}

} // namespace placedpar
