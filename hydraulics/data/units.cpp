#include "hydraulics/data/units.hpp"

#include <algorithm>
#include <array>

namespace placedpar::hydraulics {

namespace {

constexpr double psi_per_pascal = 1 / pascal_per_psi;
constexpr double inch_per_metre = 1 / metre_per_inch;
constexpr double in2_per_m2 = inch_per_metre * inch_per_metre;
constexpr double in3_per_m3 = in2_per_m2 * inch_per_metre;
constexpr double lbf_per_newton = psi_per_pascal * in2_per_m2;
// The square root of pascal_per_psi. The orifice constant k in metres and pascals is 3.0590e-4 times k in inches and
// psi.
constexpr double sqrt_pascal_per_psi = 83.03467526;

constexpr std::array all{
    Unit{"", Quantity::number, 1},
    Unit{"s", Quantity::time, 1},
    Unit{"ms", Quantity::time, 1e-3},
    Unit{"psi", Quantity::pressure, 1},
    Unit{"Pa", Quantity::pressure, psi_per_pascal},
    Unit{"kPa", Quantity::pressure, 1e3 * psi_per_pascal},
    Unit{"MPa", Quantity::pressure, 1e6 * psi_per_pascal},
    Unit{"bar", Quantity::pressure, 1e5 * psi_per_pascal},
    Unit{"in", Quantity::length, 1},
    Unit{"mm", Quantity::length, 1e-3 * inch_per_metre},
    Unit{"cm", Quantity::length, 1e-2 * inch_per_metre},
    Unit{"m", Quantity::length, inch_per_metre},
    Unit{"deg", Quantity::angle, 1},
    Unit{"rad", Quantity::angle, deg_per_rad},
    Unit{"V", Quantity::voltage, 1},
    Unit{"mV", Quantity::voltage, 1e-3},
    Unit{"in^2", Quantity::area, 1},
    Unit{"mm^2", Quantity::area, 1e-6 * in2_per_m2},
    Unit{"cm^2", Quantity::area, 1e-4 * in2_per_m2},
    Unit{"m^2", Quantity::area, in2_per_m2},
    Unit{"in^3/s", Quantity::flow, 1},
    Unit{"cm^3/s", Quantity::flow, 1e-6 * in3_per_m3},
    Unit{"L/min", Quantity::flow, 1e-3 / 60 * in3_per_m3},
    Unit{"m^3/s", Quantity::flow, in3_per_m3},
    Unit{"in^3/psi", Quantity::compliance, 1},
    Unit{"m^3/Pa", Quantity::compliance, in3_per_m3 / psi_per_pascal},
    Unit{"lbf", Quantity::force, 1},
    Unit{"N", Quantity::force, lbf_per_newton},
    Unit{"kN", Quantity::force, 1e3 * lbf_per_newton},
    Unit{"lbf s^2/in", Quantity::mass, 1},
    Unit{"kg", Quantity::mass, lbf_per_newton / inch_per_metre},
    Unit{"lbf s/in", Quantity::damping, 1},
    Unit{"N s/m", Quantity::damping, lbf_per_newton / inch_per_metre},
    Unit{"in/s", Quantity::speed, 1},
    Unit{"m/s", Quantity::speed, inch_per_metre},
    Unit{"1/s", Quantity::rate, 1},
    Unit{"psi/s", Quantity::pressure_rate, 1},
    Unit{"MPa/s", Quantity::pressure_rate, 1e6 * psi_per_pascal},
    Unit{"in^3/(s in^2 psi^0.5)", Quantity::orifice, 1},
    Unit{"m^3/(s m^2 Pa^0.5)", Quantity::orifice, (inch_per_metre * sqrt_pascal_per_psi)},
    Unit{"in^3/(s psi)", Quantity::leakage, 1},
    Unit{"m^3/(s Pa)", Quantity::leakage, in3_per_m3 / psi_per_pascal},
    Unit{"in^3", Quantity::volume, 1},
    Unit{"cm^3", Quantity::volume, 1e-6 * in3_per_m3},
    Unit{"L", Quantity::volume, 1e-3 * in3_per_m3},
    Unit{"m^3", Quantity::volume, in3_per_m3},
    Unit{"V/s", Quantity::voltage_rate, 1},
    Unit{"lbf/in", Quantity::stiffness, 1},
    Unit{"N/m", Quantity::stiffness, lbf_per_newton / inch_per_metre},
    Unit{"psi s^2/in^3", Quantity::inertance, 1},
    Unit{"Pa s^2/m^3", Quantity::inertance, psi_per_pascal / in3_per_m3},
    Unit{"psi s/in^3", Quantity::resistance, 1},
    Unit{"Pa s/m^3", Quantity::resistance, psi_per_pascal / in3_per_m3},
};

/// Other names of units, as loggers write them.
struct UnitAlias {
    std::string_view alias, name;
};

constexpr std::array aliases{
    UnitAlias{"\u00b0", "deg"},    UnitAlias{"\xb0", "deg"}, // the degree sign in UTF-8, and in Latin-1
    UnitAlias{"degree", "deg"},    UnitAlias{"degrees", "deg"},   UnitAlias{"sec", "s"},
    UnitAlias{"seconds", "s"},     UnitAlias{"msec", "ms"},       UnitAlias{"psig", "psi"},
    UnitAlias{"barg", "bar"},      UnitAlias{"inch", "in"},       UnitAlias{"inches", "in"},
    UnitAlias{"volt", "V"},        UnitAlias{"volts", "V"},       UnitAlias{"Volts", "V"},
    UnitAlias{"in\u00b2", "in^2"}, UnitAlias{"mm\u00b2", "mm^2"}, UnitAlias{"cm\u00b2", "cm^2"},
};

struct QuantityName {
    Quantity quantity;
    std::string_view name;
};

constexpr std::array quantity_names{
    QuantityName{Quantity::number, "number"},
    QuantityName{Quantity::time, "time"},
    QuantityName{Quantity::pressure, "pressure"},
    QuantityName{Quantity::length, "length"},
    QuantityName{Quantity::angle, "angle"},
    QuantityName{Quantity::voltage, "voltage"},
    QuantityName{Quantity::area, "area"},
    QuantityName{Quantity::flow, "flow"},
    QuantityName{Quantity::compliance, "compliance"},
    QuantityName{Quantity::force, "force"},
    QuantityName{Quantity::mass, "mass"},
    QuantityName{Quantity::damping, "damping"},
    QuantityName{Quantity::speed, "speed"},
    QuantityName{Quantity::rate, "rate"},
    QuantityName{Quantity::pressure_rate, "pressure rate"},
    QuantityName{Quantity::orifice, "orifice constant"},
    QuantityName{Quantity::leakage, "leakage"},
    QuantityName{Quantity::volume, "volume"},
    QuantityName{Quantity::voltage_rate, "voltage rate"},
    QuantityName{Quantity::stiffness, "stiffness"},
    QuantityName{Quantity::inertance, "inertance"},
    QuantityName{Quantity::resistance, "resistance"},
};

} // namespace

const Unit* unit_named(std::string_view name) {
    const auto* alias = std::ranges::find(aliases, name, &UnitAlias::alias);
    const auto* found = std::ranges::find(all, alias == aliases.end() ? name : alias->name, &Unit::name);
    return found == all.end() ? nullptr : found;
}

std::vector<Unit> units_of(Quantity quantity) {
    std::vector<Unit> units;
    for (const Unit& unit : all)
        if (unit.quantity == quantity)
            units.push_back(unit);
    return units;
}

std::string list_units(Quantity quantity) {
    std::string list;
    auto units = units_of(quantity);
    for (std::size_t i = 0; i < units.size(); ++i)
        list += (i == 0 ? "" : i + 1 == units.size() ? " or " : ", ") + std::string(units[i].name);
    return list;
}

std::string_view name_of(Quantity quantity) {
    return std::ranges::find(quantity_names, quantity, &QuantityName::quantity)->name;
}

} // namespace placedpar::hydraulics
