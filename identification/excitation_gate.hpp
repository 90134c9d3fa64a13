#pragma once

#include <optional>

namespace placedpar::identification {

/// Stops the search while a link's pressure moves too slowly over the window: then the samples contain no information,
/// and a search would follow the noise. A sufficient flow into the compliance also opens the gate, so that a soft hose,
/// whose pressure rises slowly, still passes.
struct ExcitationGate {
    double slope_psi_per_s = 800; ///< least rms slope; ours: with up to medium noise, 9 of 10 estimates are within 10 %

    /// The thesis's compliance, at which the limits on slope and on flow are equal.
    static constexpr double thesis_in3_per_psi = 0.0086;
    /// The required share of the slope while no compliance has been found: 150 psi/s, as in UsableSamples.
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
