#pragma once

#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/link.hpp"
#include "hydraulics/data/parameters.hpp"

namespace placedpar::identification {

/// The constants of an excavator that the on-line diagnosis needs.
struct ExcavatorParameters {
    double period_s = 0; ///< time between samples
    hydraulics::FlowConstants flow{};
    hydraulics::PerLink<hydraulics::LinkConstants> links{};
    hydraulics::PerLink<double> compliance_in3_per_psi{}; ///< compliances of healthy machines of this kind; above 0

    friend bool operator==(const ExcavatorParameters&, const ExcavatorParameters&) = default;
};

/// Takes the constants from the machine's parameters. The compliance of a healthy link is the parameter
/// LINK.inlet_compliance. The sampling period is 20 ms, as in the thesis.
ExcavatorParameters excavator_parameters(const hydraulics::Parameters& parameters);

} // namespace placedpar::identification
