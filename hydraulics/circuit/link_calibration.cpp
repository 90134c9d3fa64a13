#include "hydraulics/circuit/link_calibration.hpp"

#include "hydraulics/data/parameters.hpp"

#include <fmt/format.h>

#include <string_view>

namespace placedpar::hydraulics {

PerLink<LinkConstants> link_constants(const Parameters& parameters) {
    PerLink<LinkConstants> constants;
    for (Link link : all_links) {
        auto value = [&](std::string_view what) { return parameters[fmt::format("{}.{}", name_of(link), what)]; };
        constants[index_of(link)] = {piston_in3_per_rad(value("inlet_area"), value("moment_arm")), value("spool_lag")};
    }
    return constants;
}

LinkCalibrations link_calibrations(const Parameters& parameters) {
    PerLink<LinkConstants> constants = link_constants(parameters);
    LinkCalibrations calibrations;
    for (Link link : all_links)
        calibrations[index_of(link)].constants = constants[index_of(link)];
    return calibrations;
}

LinkCalibrations drain_calibrations(const Parameters& parameters) {
    LinkCalibrations calibrations = link_calibrations(parameters);
    calibrations[index_of(Link::boom)].constants.piston_in3_per_rad =
        -piston_in3_per_rad(parameters["boom.outlet_area"], parameters["boom.moment_arm"]);
    return calibrations;
}

AreasFrom areas_from(const ChannelSet& there, Link link, std::optional<AreasFrom> asked, Side side) {
    if (asked)
        return *asked;
    if (side == Side::inlet && there.contains(link, Sensor::inlet_area) && there.contains(link, Sensor::bypass_area))
        return AreasFrom::areas;
    return there.contains(link, Sensor::spool) || !there.contains(link, Sensor::servo) ? AreasFrom::spool
                                                                                       : AreasFrom::servo;
}

ChannelSet channels_needed(Link link, AreasFrom from, Side side) {
    ChannelSet needed;
    needed.insert(link, pressure_sensor(side));
    needed.insert(link, Sensor::angle);
    switch (from) {
    case AreasFrom::areas:
        needed.insert(link, Sensor::inlet_area);
        needed.insert(link, Sensor::bypass_area);
        break;
    case AreasFrom::spool: needed.insert(link, Sensor::spool); break;
    case AreasFrom::servo: needed.insert(link, Sensor::servo); break;
    }
    return needed;
}

namespace {

std::string list_channels(const Record& record) {
    std::string channels;
    for (Link link : all_links)
        for (Sensor sensor : all_sensors)
            if (record.has(link, sensor))
                channels += fmt::format("{}{}.{}", channels.empty() ? "" : ", ", name_of(link), name_of(sensor));
    return channels;
}

} // namespace

void require_channels(const Record& record, Link link, AreasFrom from, Side side) {
    const ChannelSet needed = channels_needed(link, from, side);
    for (Sensor sensor : all_sensors)
        if (needed.contains(link, sensor) && !record.has(link, sensor))
            throw UnfitRecord(fmt::format("the record has no channel {}.{}; it has {}", name_of(link), name_of(sensor),
                                          list_channels(record)));
}

} // namespace placedpar::hydraulics
