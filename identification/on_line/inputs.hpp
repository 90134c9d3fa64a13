#pragma once

#include "hydraulics/circuit/circuit.hpp"
#include "hydraulics/data/link.hpp"

#include <optional>
#include <variant>

namespace placedpar::identification {

/// These types hold what a control system reports about its excavator to the on-line diagnosis.

/// The main valve has changed its configuration, or other links move.
struct ConfigurationChange {
    hydraulics::Configuration configuration;
    hydraulics::LinkSet active;
};

/// The control system does not report configuration and moving links. From now on, the diagnosis recognises them from
/// the readings of all four links.
struct RecognisedConfiguration {};

/// The opening of a valve is given by the position of its spool, by the voltage that moves the spool, or by its areas.
struct SpoolPosition {
    double spool_in;
};
struct ServoVoltage {
    double servo_V;
};
struct ValveAreas {
    double inlet_in2, bypass_in2;
};

/// The readings of one link's sensors at one instant.
struct Reading {
    double inlet_psi;
    double angle_deg;
    std::variant<SpoolPosition, ServoVoltage, ValveAreas> valve;
};

/// The readings of one sampling instant.
struct ExcavatorSample {
    double time_s;
    hydraulics::PerLink<std::optional<Reading>> links; ///< nullopt: the link was not read
};

/// The compliances of a healthy excavator, with which the diagnosis compares its estimates.
struct Baseline {
    hydraulics::PerLink<std::optional<double>> compliance_in3_per_psi; ///< nullopt: keep the link's present value
};

} // namespace placedpar::identification
