#include "explore/identify/ways.hpp"

#include "explore/identify/question.hpp"
#include "identification/flags.hpp"
#include "identification/offset_calibration.hpp"
#include "identification/report/identification_report.hpp"
#include "identification/whole_search.hpp"
#include "text/counted.hpp"
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

/// Returns the way of identification, with the user's settings in place of its defaults.
IdentificationWay way_of(const IdentifySettings& settings, IdentificationWay way) {
    change_way(way, settings);
    if (!settings.coding.empty())
        way.coding = Coding::named(settings.coding);
    way.usable.count = settings.samples.value_or(way.usable.count);
    way.usable.rising = settings.rising;
    way.search.validate();
    if (std::size_t needed = samples_for_first_generation(way); way.usable.count < needed)
        throw UserError(fmt::format("--samples {}: expected at least {}, which the first generation needs",
                                    way.usable.count, needed));
    return way;
}

/// Returns the source of the position of the boom's spool, if the boom's areas come from this position: the spool's
/// readings, or the voltage by equation A.1.
std::optional<AreasFrom> source_of_spool(const Record& record, const Question& question) {
    if (!question.links.contains(Link::boom))
        return std::nullopt;
    const AreasFrom from = areas_from(record.channels(), Link::boom, question.areas_from);
    return from == AreasFrom::areas ? std::nullopt : std::optional(from);
}

/// A record, and the settings for its identification.
struct Case {
    Parameters machine;
    LoadedRecord loaded;
    Sampling sampling; ///< how the readings were averaged to the record's samples
    IdentificationWay way;
    Question question;
    bool calibrates = false;                ///< the offset is calibrated from the record (`--offset auto`, the default)
    std::optional<SpoolOffset> calibration; ///< set if the calibration found the offset
};

std::string print_calibration(const std::optional<SpoolOffset>& found) {
    if (!found)
        return "spool offset: not calibrated, because the record has less than a second of steady motion\n";
    return fmt::format("spool offset: {:+.5f} in, standard error {:.5f}, from {} samples of steady motion\n",
                       found->offset_in, found->deviation_in, found->samples);
}

/// Calibrates the offset of the boom's spool from the samples of the record with steady motion. `from` is the source of
/// the spool's position.
void calibrate(Case& asked, AreasFrom from) {
    const Sensor sensor = from == AreasFrom::servo ? Sensor::servo : Sensor::spool;
    asked.calibrates =
        asked.loaded.record.has(Link::boom, sensor) && asked.loaded.record.has(Link::boom, Sensor::inlet_pressure);
    LinkCalibrations calibrations = link_calibrations(asked.machine);
    calibrations[index_of(Link::boom)].from = from;
    if (asked.calibrates)
        asked.calibration = calibrate_spool_offset(asked.loaded.record, calibrations, flow_constants(asked.machine));
    if (asked.calibration)
        asked.question.spool_offset_in = asked.calibration->offset_in;
}

LinkSet links_asked(const IdentifySettings& settings) {
    return settings.links.empty() ? LinkSet{Link::boom} : links_of(settings.links);
}

Case read_case(const IdentifySettings& settings, const RecordInput& input, const IdentifyOutput& output,
               const IdentificationWay& way) {
    Case asked;
    asked.way = way_of(settings, way);
    const LinkSet links = links_asked(settings);
    asked.question = {*configuration_named(settings.configuration), links, std::nullopt, areas_asked(settings),
                      side_asked(settings)};
    bool automatic = settings.offset.empty() || settings.offset == "auto";
    if (!automatic && settings.offset != "none")
        asked.question.spool_offset_in = offset_asked(settings.offset);
    asked.machine = load_machine(settings.machine, output.warn);
    asked.loaded = input.whole(needs_of(settings, [links](const ChannelSet&) { return links; }));
    asked.sampling = Sampling::of(asked.loaded.record.period_s);
    if (asked.sampling.readings > 1)
        asked.loaded.record = averaged(asked.loaded.record, asked.sampling);
    const auto from = source_of_spool(asked.loaded.record, asked.question);
    if (!from) {
        if (asked.question.spool_offset_in)
            throw UserError(fmt::format("--offset {}: the option has no effect, because no area is computed from "
                                        "the boom's spool",
                                        settings.offset));
    } else if (automatic) {
        calibrate(asked, *from);
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

/// The results of begin(), which does the work before the search for both ways of identification, "thesis" and "whole".
struct Begun {
    Case asked;
    ComplianceSearch prepared;
};

Begun begin(const IdentifySettings& settings, const RecordInput& input, const IdentifyOutput& output,
            const IdentificationWay& way) {
    Case asked = read_case(settings, input, output, way);
    output.json["warnings"] = warnings_json(asked.loaded.warnings);
    output.json["sampling"] = sampling_json(asked.sampling);
    ComplianceSearch prepared = prepare(asked.loaded.record, asked.machine, asked.question, asked.way);
    return {std::move(asked), std::move(prepared)};
}

/// Flags doubtful answers, adds the results to the JSON and returns the text of the results.
std::string report(Identified& identified, const Begun& begun, const IdentifyOutput& output) {
    const Case& asked = begun.asked;
    flag_spikes(identified, asked.loaded.record, begun.prepared.samples);
    if (asked.calibration)
        flag_calibration(identified, *asked.calibration, spool_sensor_step_in(asked.machine));
    for (auto& [key, value] : identified_json(identified, begun.prepared))
        output.json[key] = value;
    return (asked.sampling.readings > 1 ? print_sampling(asked.sampling) + "\n" : "") +
           (asked.calibrates ? print_calibration(asked.calibration) : "") +
           print_identified(identified, begun.prepared, asked.way);
}

} // namespace

IdentifyEnd identify_over_whole(const IdentifySettings& settings, const RecordInput& input,
                                const IdentifyOutput& output) {
    WholeWay whole = whole_way(links_asked(settings).size(), side_asked(settings));
    const Begun begun = begin(settings, input, output, whole.way);
    whole.way = begun.asked.way;
    Identified identified = identify_whole(begun.prepared, whole, settings.seed);
    const std::string text = report(identified, begun, output);
    const SearchCost cost =
        cost_of(whole, begun.prepared.problem, identified.generations, begun.prepared.samples.size());
    output.print(text + print_whole(identified, begun.prepared, whole, cost));
    output.json["cost"] = cost_json(cost);
    return identified.flagged() ? IdentifyEnd::doubtful : IdentifyEnd::sound;
}

ThesisAnswer identify_by_thesis(const IdentifySettings& settings, const RecordInput& input,
                                const IdentifyOutput& output) {
    Begun begun = begin(settings, input, output, thesis_way());
    Identified identified =
        identify(begun.prepared.problem, begun.prepared.flow, begun.prepared.samples, begun.asked.way, settings.seed);
    std::string text = report(identified, begun, output);
    return {begun.asked.way, std::move(begun.prepared), std::move(identified), std::move(text)};
}

} // namespace placedpar
