#pragma once

#include "hydraulics/data/link.hpp"
#include "hydraulics/data/record.hpp"

#include <numbers>
#include <optional>

namespace placedpar::hydraulics {

class Parameters; // hydraulics/data/parameters.hpp

/// How sensors' readings become flows and areas.

/// What the pump side of a link takes up per radian of its joint, in^3/rad: A_i times the moment arm; for the swing,
/// the displacement of its motor.
constexpr double piston_in3_per_rad(double inlet_area_in2, double moment_arm_in) {
    return inlet_area_in2 * moment_arm_in;
}

/// Where the areas of a link's orifices come from: as they were read, or by the boom's functions A.3 to A.9 from the
/// spool, or from the servo-valve's voltage by A.1 and A.2.
enum class AreasFrom : unsigned char { areas, spool, servo };

/// What the readings of one link become flows by.
struct LinkConstants {
    double piston_in3_per_rad = 0; ///< taken up by the pump side per radian of the joint
    double spool_lag_per_s = 0;    ///< a_0 of A.2

    double piston_in3_per_deg() const { return piston_in3_per_rad * std::numbers::pi / 180; }
    friend bool operator==(const LinkConstants&, const LinkConstants&) = default;
};

/// By the rows inlet_area, moment_arm and spool_lag of each link.
PerLink<LinkConstants> link_constants(const Parameters& parameters);

/// What turns the readings of one link into flows and areas.
struct LinkCalibration {
    LinkConstants constants;
    double spool_offset_in = 0;         ///< by which the spool's readings, or A.1, are too high
    std::optional<AreasFrom> from = {}; ///< none: the first of the three that the record has
};
using LinkCalibrations = PerLink<LinkCalibration>;

/// By link_constants(), without an offset.
LinkCalibrations link_calibrations(const Parameters& parameters);

/// The source that is asked for, or the first of the three that is there of the link.
AreasFrom areas_from(const ChannelSet& there, Link link, std::optional<AreasFrom> asked);

/// What flows and areas of a link come from: inlet pressure, angle, and what its areas are found by.
ChannelSet channels_needed(Link link, AreasFrom from);
/// Throws UnfitRecord, naming the first of those that is missing and the channels there are.
void require_channels(const Record& record, Link link, AreasFrom from);

} // namespace placedpar::hydraulics
