#pragma once

#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/data/link.hpp"

namespace placedpar::identification {

/// What turns the readings of one link into flows.
struct LinkParameters {
    double piston_in3_per_rad; ///< A_i times the moment arm, or the displacement of a motor
    double spool_lag_per_s;    ///< a_0 of A.2

    friend bool operator==(const LinkParameters&, const LinkParameters&) = default;
};

/// By hydraulics/data/excavator.csv.
hydraulics::PerLink<LinkParameters> default_link_parameters();

/// What the on-line diagnosis has to know of an excavator.
struct ExcavatorParameters {
    double period_s = 0.020; ///< between samples; thesis
    hydraulics::FlowConstants flow = hydraulics::fitted_flow_constants();
    hydraulics::PerLink<LinkParameters> links = default_link_parameters();

    friend bool operator==(const ExcavatorParameters&, const ExcavatorParameters&);
};

} // namespace placedpar::identification
