#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/data/link.hpp"

#include <optional>
#include <variant>

namespace placedpar::identification {

/// What a control system tells the on-line diagnosis of its excavator, in plain values: how they arrive is the
/// monitor's business.

struct ConfigurationChange {
    hydraulics::Configuration configuration;
    hydraulics::LinkSet active;
};

/// A valve is known by its spool, by the voltage that moves the spool, or by the areas that it opens.
struct SpoolPosition {
    double spool_in;
};
struct ServoVoltage {
    double servo_V;
};
struct ValveAreas {
    double inlet_in2, bypass_in2;
};

/// What the sensors of one link read at one sampling instant.
struct Reading {
    double inlet_psi;
    double angle_deg;
    std::variant<SpoolPosition, ServoVoltage, ValveAreas> valve;
};

/// The readings of one sampling instant.
struct ExcavatorSample {
    double time_s;
    hydraulics::PerLink<std::optional<Reading>> links; ///< none: the link was not read
};

/// The compliances of a healthy excavator.
struct Baseline {
    hydraulics::PerLink<std::optional<double>> compliance_in3_per_psi; ///< none: leave the link's as it is
};

} // namespace placedpar::identification
