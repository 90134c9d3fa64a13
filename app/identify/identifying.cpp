#include "app/identify/identifying.hpp"

#include "app/identify/question.hpp"
#include "app/options/link_options.hpp"
#include "app/standard_error.hpp"
#include "explore/load.hpp"
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

LinkSet wanted_links(const IdentifyOptions& options, const ChannelSet& there) {
    return options.links.empty() ? links_to_diagnose(there) : links_of(options.links);
}

/// Rounds a period to whole nanoseconds, since clock steps written as decimals are whole nanoseconds.
double whole_nanoseconds(double period_s) { return std::round(period_s * 1e9) / 1e9; }

LinkSet required_links(const IdentifyOptions& options, const Record& first) {
    const LinkSet wanted = wanted_links(options, first.channels());
    if (!wanted.empty())
        return wanted;
    for (Link link : links_of(first.links())) // throws an error that names the channels that the first link lacks
        require_channels(first, link, areas_from(first.channels(), link, areas_asked(options)));
    throw UnfitRecord("no link has all readings that identification needs: inlet_pressure, angle, and spool "
                      "or servo or (inlet_area and bypass_area)");
}

Diagnosis diagnosis_of(const IdentifyOptions& options, const Record& first, const DiagnosisSettings& settings,
                       LinkSet links) {
    ExcavatorParameters machine = excavator_parameters(load_machine(options.machine, print_warnings));
    machine.period_s = whole_nanoseconds(first.period_s);
    Diagnosis diagnosis(machine_name, machine, settings, options.seed);
    diagnosis.change({*configuration_named(options.configuration), links});
    return diagnosis;
}

PerLink<LinkReader> readers_of(const IdentifyOptions& options, const Record& first, LinkSet links) {
    PerLink<LinkReader> readers;
    const bool offset = !options.offset.empty() && options.offset != "none";
    for (Link link : links_of(links)) {
        const AreasFrom from = areas_from(first.channels(), link, areas_asked(options));
        require_channels(first, link, from);
        readers[index_of(link)].from = from;
    }
    LinkReader& boom = readers[index_of(Link::boom)];
    if (offset && (!links.contains(Link::boom) || boom.from != AreasFrom::spool))
        throw UserError(fmt::format("--offset {}: the option has no effect, because no area is computed from "
                                    "the boom's spool",
                                    options.offset));
    boom.spool_offset_in = offset ? offset_asked(options.offset) : 0;
    return readers;
}

} // namespace

DiagnosisSettings settings_of(const IdentifyOptions& options) {
    DiagnosisSettings settings;
    settings.bits = options.bits.value_or(settings.bits);
    settings.search.elite = options.elite.value_or(settings.search.elite);
    settings.search.population = options.population.value_or(settings.search.population);
    settings.search.window.trials = options.trials.value_or(settings.search.window.trials);
    settings.search.window.length = options.window.value_or(settings.search.window.length);
    settings.search.window.bias = options.bias;
    settings.validate();
    return settings;
}

bool moves(const IdentifyOptions& options, const ChannelSet& there) {
    return options.configuration.empty() && recognisable(there);
}

RecordNeeds needs_of_service(const IdentifyOptions& options) {
    return needs_of(options, [options](const ChannelSet& there) {
        return moves(options, there) ? LinkSet::all() : wanted_links(options, there);
    });
}

Identifying::Identifying(const IdentifyOptions& options, const Record& first)
    : settings_(settings_of(options)), links_(required_links(options, first)),
      diagnosis_(diagnosis_of(options, first, settings_, links_), settings_, readers_of(options, first, links_)) {}

void refuse_rest(const Identifying& identifying) {
    throw UnfitRecord(fmt::format("no movement in {}: expected a valve that opens for long enough while the pressure "
                                  "lets oil flow into the cylinder",
                                  counted(identifying.diagnosis().samples(), "sample")));
}

} // namespace placedpar
