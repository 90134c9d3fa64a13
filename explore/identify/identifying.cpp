#include "explore/identify/identifying.hpp"

#include "explore/identify/question.hpp"
#include "hydraulics/circuit/circuit.hpp"
#include "identification/on_line/moving_identification.hpp"
#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// The monitor uses the same random numbers for a machine of this name.
constexpr const char* machine_name = "record";

LinkSet wanted_links(const IdentifySettings& settings, const ChannelSet& there) {
    return settings.links.empty() ? links_to_diagnose(there) : links_of(settings.links);
}

/// Rounds a period to whole nanoseconds, since clock steps written as decimals are whole nanoseconds.
double whole_nanoseconds(double period_s) { return std::round(period_s * 1e9) / 1e9; }

LinkSet required_links(const IdentifySettings& settings, const Record& first) {
    const LinkSet wanted = wanted_links(settings, first.channels());
    if (!wanted.empty())
        return wanted;
    for (Link link : links_of(first.links())) // throws an error that names the channels that the first link lacks
        require_channels(first, link, areas_from(first.channels(), link, areas_asked(settings)));
    throw UnfitRecord("no link has all readings that identification needs: inlet_pressure, angle, and spool "
                      "or servo or (inlet_area and bypass_area)");
}

Diagnosis diagnosis_of(const IdentifySettings& given, const Record& first, const DiagnosisSettings& settings,
                       LinkSet links, const WarningSink& warn) {
    ExcavatorParameters machine = excavator_parameters(load_machine(given.machine, warn));
    machine.period_s = whole_nanoseconds(first.period_s);
    Diagnosis diagnosis(machine_name, machine, settings, given.seed);
    diagnosis.change({*configuration_named(given.configuration), links});
    return diagnosis;
}

PerLink<LinkReader> readers_of(const IdentifySettings& settings, const Record& first, LinkSet links) {
    PerLink<LinkReader> readers;
    const bool offset = !settings.offset.empty() && settings.offset != "none";
    for (Link link : links_of(links)) {
        const AreasFrom from = areas_from(first.channels(), link, areas_asked(settings));
        require_channels(first, link, from);
        readers[index_of(link)].from = from;
    }
    LinkReader& boom = readers[index_of(Link::boom)];
    if (offset && (!links.contains(Link::boom) || boom.from != AreasFrom::spool))
        throw UserError(fmt::format("--offset {}: the option has no effect, because no area is computed from "
                                    "the boom's spool",
                                    settings.offset));
    boom.spool_offset_in = offset ? offset_asked(settings.offset) : 0;
    return readers;
}

} // namespace

DiagnosisSettings settings_of(const IdentifySettings& given) {
    DiagnosisSettings settings;
    change_way(settings, given);
    settings.validate();
    return settings;
}

bool moves(const IdentifySettings& settings, const ChannelSet& there) {
    return settings.configuration.empty() && recognisable(there);
}

RecordNeeds needs_of_service(const IdentifySettings& settings) {
    return needs_of(settings, [settings](const ChannelSet& there) {
        return moves(settings, there) ? LinkSet::all() : wanted_links(settings, there);
    });
}

Identifying::Identifying(const IdentifySettings& settings, const Record& first, const WarningSink& warn)
    : settings_(settings_of(settings)), links_(required_links(settings, first)),
      diagnosis_(diagnosis_of(settings, first, settings_, links_, warn), settings_,
                 readers_of(settings, first, links_)) {}

void refuse_rest(const Identifying& identifying) {
    throw UnfitRecord(
        fmt::format("no movement was found in {}: expected a valve that opens for long enough while the pressure "
                    "lets oil flow into the cylinder",
                    counted(identifying.diagnosis().samples(), "sample")));
}

} // namespace placedpar
