#pragma once

#include "hydraulics/data/link.hpp"
#include "hydraulics/data/record.hpp"

#include <numbers>
#include <optional>

namespace placedpar::hydraulics {

class Parameters; // hydraulics/data/parameters.hpp

/// Returns the volume of oil that turns a link's joint by one radian, in in^3/rad: the piston's area times the moment
/// arm. For the swing, which has a motor in place of a cylinder, this volume is the motor's displacement.
constexpr double piston_in3_per_rad(double inlet_area_in2, double moment_arm_in) {
    return inlet_area_in2 * moment_arm_in;
}

/// Selects the source of a link's orifice areas. The areas are either in the record, or follow from the spool's
/// position (A.3 to A.9) or from the servo-valve's voltage (A.1 to A.9).
enum class AreasFrom : unsigned char { areas, spool, servo };

/// The constants that convert the readings of one link to flows.
struct LinkConstants {
    /// The volume of oil that this side of the cylinder takes per radian of the joint. It is negative on the outlet
    /// side.
    double piston_in3_per_rad = 0;
    double spool_lag_per_s = 0; ///< a_0 of A.2, the lag between voltage and spool

    double piston_in3_per_deg() const { return piston_in3_per_rad * std::numbers::pi / 180; }
    friend bool operator==(const LinkConstants&, const LinkConstants&) = default;
};

/// Reads the parameters inlet_area, moment_arm and spool_lag of each link.
PerLink<LinkConstants> link_constants(const Parameters& parameters);

/// Everything that converts the readings of one link to flows and areas.
struct LinkCalibration {
    LinkConstants constants;
    /// The spool's readings, or the positions computed from voltages, are too high by this offset.
    double spool_offset_in = 0;
    std::optional<AreasFrom> from = {}; ///< nullopt: the first of the three sources that the record has
};
using LinkCalibrations = PerLink<LinkCalibration>;

/// Returns calibrations with the constants of link_constants() and without an offset.
LinkCalibrations link_calibrations(const Parameters& parameters);
/// Returns the calibrations of the outlet sides. The parameters describe only the boom's outlet side
/// (boom.outlet_area); the other links keep the constants of their inlet sides.
LinkCalibrations drain_calibrations(const Parameters& parameters);

/// Returns `asked`. If `asked` is nullopt, returns the first of `areas`, `spool` and `servo` whose channels are in
/// `there`. For an outlet side, returns `spool` or `servo`, because no sensor reads the area of an outlet.
AreasFrom areas_from(const ChannelSet& there, Link link, std::optional<AreasFrom> asked, Side side = Side::inlet);

/// Returns the channels that a record needs for the flows and areas of one side of a link: the side's pressure, the
/// joint's angle, and the source of the areas.
ChannelSet channels_needed(Link link, AreasFrom from, Side side = Side::inlet);
/// Throws UnfitRecord if one of channels_needed() is missing; the message names the first such channel and the channels
/// present.
void require_channels(const Record& record, Link link, AreasFrom from, Side side = Side::inlet);

} // namespace placedpar::hydraulics
