#include "hydraulics/circuit/link_calibration.hpp"

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

AreasFrom areas_from(const Record& record, Link link, const LinkCalibration& calibration) {
    if (calibration.from)
        return *calibration.from;
    if (record.has(link, Sensor::inlet_area) && record.has(link, Sensor::bypass_area))
        return AreasFrom::areas;
    return record.has(link, Sensor::spool) || !record.has(link, Sensor::servo) ? AreasFrom::spool : AreasFrom::servo;
}

} // namespace placedpar::hydraulics
