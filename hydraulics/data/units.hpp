#pragma once

#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::hydraulics {

/// The physical quantities. In hydraulics/, all values of a quantity have the same unit, the unit of the thesis.
enum class Quantity : unsigned char {
    number,        ///< without a unit
    time,          ///< s
    pressure,      ///< psi, gauge
    length,        ///< in
    angle,         ///< deg
    voltage,       ///< V
    area,          ///< in^2
    flow,          ///< in^3/s
    compliance,    ///< in^3/psi
    force,         ///< lbf
    mass,          ///< lbf s^2/in
    damping,       ///< lbf s/in
    speed,         ///< in/s
    rate,          ///< 1/s
    pressure_rate, ///< psi/s
    orifice,       ///< in^3/(s in^2 psi^0.5): k = Cd sqrt(2 / density)
    leakage,       ///< in^3/(s psi)
    volume,        ///< in^3
    voltage_rate,  ///< V/s
    stiffness,     ///< lbf/in
    inertance,     ///< psi s^2/in^3: pressure per acceleration of a line's flow
    resistance     ///< psi s/in^3: pressure loss per flow in a line
};

/// A unit. `factor` is its size in the unit that Quantity lists, so a value times `factor` is in that unit.
struct Unit {
    std::string_view name;
    Quantity quantity;
    double factor;
};

/// Pascals per psi and metres per inch. All other factors between metric and these units follow from these two.
inline constexpr double pascal_per_psi = 6894.757293168361;
inline constexpr double metre_per_inch = 0.0254;
inline constexpr double deg_per_rad = 180 / std::numbers::pi;

/// Returns the unit with a name such as "cm^3/s", "kPa" or "deg", or with another name that loggers use. Returns null
/// if no unit has this name.
const Unit* unit_named(std::string_view name);

/// Returns all units of a quantity, beginning with the unit that Quantity lists.
std::vector<Unit> units_of(Quantity);
/// Returns a text for messages: "psi, Pa, kPa, MPa or bar".
std::string list_units(Quantity);
std::string_view name_of(Quantity);

} // namespace placedpar::hydraulics
