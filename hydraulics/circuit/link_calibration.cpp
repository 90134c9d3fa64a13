#include "hydraulics/circuit/link_calibration.hpp"

#include <fmt/format.h>

#include <string_view>

namespace placedpar::hydraulics {

LinkCalibrations link_calibrations(const Parameters& parameters) {
    LinkCalibrations calibrations;
    for (Link link : all_links) {
        auto value = [&](std::string_view what) { return parameters[fmt::format("{}.{}", name_of(link), what)]; };
        LinkCalibration& calibration = calibrations[index_of(link)];
        calibration.piston_in3_per_rad = piston_in3_per_rad(value("inlet_area"), value("moment_arm"));
        calibration.spool_lag_per_s = value("spool_lag");
    }
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
