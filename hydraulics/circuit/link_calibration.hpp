#pragma once

#include "hydraulics/data/link.hpp"
#include "hydraulics/data/record.hpp"

#include <numbers>
#include <optional>

namespace placedpar::hydraulics {

class Parameters; // hydraulics/data/parameters.hpp

/// Returns the volume that the pump side of a link takes per radian of its joint, in in^3/rad: A_i times the moment
/// arm. For the swing this volume is the displacement of its motor.
constexpr double piston_in3_per_rad(double inlet_area_in2, double moment_arm_in) {
    return inlet_area_in2 * moment_arm_in;
}

/// Selects the source of a link's orifice areas: read directly, computed from the spool by the boom's functions A.3 to
/// A.9, or computed from the servo-valve's voltage by A.1 to A.9.
enum class AreasFrom : unsigned char { areas, spool, servo };

/// The constants that convert the readings of one link to flows.
struct LinkConstants {
    double piston_in3_per_rad = 0; ///< volume that the side of the link takes per radian of the joint; negative on the
                                   ///< outlet side
    double spool_lag_per_s = 0;    ///< a_0 of A.2

    double piston_in3_per_deg() const { return piston_in3_per_rad * std::numbers::pi / 180; }
    friend bool operator==(const LinkConstants&, const LinkConstants&) = default;
};

/// Reads the rows inlet_area, moment_arm and spool_lag of each link.
PerLink<LinkConstants> link_constants(const Parameters& parameters);

/// Everything that converts the readings of one link to flows and areas.
struct LinkCalibration {
    LinkConstants constants;
    double spool_offset_in = 0; ///< the spool's readings, or the positions that A.1 gives, are too high by this offset
    std::optional<AreasFrom> from = {}; ///< nullopt: the first of the three sources that the record has
};
using LinkCalibrations = PerLink<LinkCalibration>;

/// Returns the calibrations with link_constants() and without an offset.
LinkCalibrations link_calibrations(const Parameters& parameters);
/// Returns the calibrations of the outlet sides. The parameters describe only the boom's outlet side
/// (boom.outlet_area); the other links keep the constants of their inlet sides.
LinkCalibrations drain_calibrations(const Parameters& parameters);

/// Returns `asked`; if it is nullopt, returns the first of `areas`, `spool` and `servo` whose channels are in `there`.
/// No sensor reads the area of an outlet.
AreasFrom areas_from(const ChannelSet& there, Link link, std::optional<AreasFrom> asked, Side side = Side::inlet);

/// Returns the channels from which the flows and areas of one side of a link are computed: the side's pressure, the
/// angle, and the source of the areas.
ChannelSet channels_needed(Link link, AreasFrom from, Side side = Side::inlet);
/// Throws UnfitRecord if one of channels_needed() is missing; the message names the first such channel and the channels
/// present.
void require_channels(const Record& record, Link link, AreasFrom from, Side side = Side::inlet);

} // namespace placedpar::hydraulics
