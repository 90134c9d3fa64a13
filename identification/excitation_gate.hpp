#pragma once

#include <optional>

namespace placedpar::identification {

/// The gate decides whether the search for a link's compliance may run. A pressure that hardly changes says nothing
/// about the compliance, and the search would follow the noise. Therefore the gate is open only while the link's
/// pressure changes fast enough over the window of samples, or while enough oil flows into the compliance. The second
/// condition admits a soft hose, whose pressure rises slowly. While the gate is shut, the estimate of the compliance
/// stays unchanged; it is called frozen.
struct ExcitationGate {
    double slope_psi_per_s = 800; ///< least rms slope of the pressure; chosen so that with up to medium noise, 9 of 10
                                  ///< estimates are right to within 10 %

    /// The boom's compliance in the thesis. For a link with this compliance, both conditions demand the same slope.
    static constexpr double thesis_in3_per_psi = 0.0086;
    /// Until a first compliance is found, this share of `slope_psi_per_s` suffices: 150 psi/s, as in UsableSamples
    /// (hydraulics/circuit/circuit_sample.hpp).
    static constexpr double first_share = 150. / 800;

    /// Returns whether the search may run, given the rms slope over a window and the latest compliance.
    bool opens(double rms_psi_per_s, std::optional<double> compliance_in3_per_psi) const {
        if (!compliance_in3_per_psi)
            return rms_psi_per_s >= first_share * slope_psi_per_s;
        return rms_psi_per_s >= slope_psi_per_s ||
               rms_psi_per_s * *compliance_in3_per_psi >= slope_psi_per_s * thesis_in3_per_psi;
    }
    friend bool operator==(const ExcitationGate&, const ExcitationGate&) = default;
};

} // namespace placedpar::identification
