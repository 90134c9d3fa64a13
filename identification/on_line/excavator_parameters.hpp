#pragma once

#include "hydraulics/circuit/flow_constants.hpp"
#include "hydraulics/circuit/link_calibration.hpp"
#include "hydraulics/data/link.hpp"
#include "hydraulics/data/parameters.hpp"

namespace placedpar::identification {

/// What the on-line diagnosis has to know of an excavator.
struct ExcavatorParameters {
    double period_s = 0; ///< between samples
    hydraulics::FlowConstants flow{};
    hydraulics::PerLink<hydraulics::LinkConstants> links{};

    friend bool operator==(const ExcavatorParameters&, const ExcavatorParameters&) = default;
};

/// By the rows of link_constants() and flow_constants(); a sample every 20 ms, as in the thesis.
ExcavatorParameters excavator_parameters(const hydraulics::Parameters& parameters);

} // namespace placedpar::identification
