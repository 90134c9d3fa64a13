#pragma once

#include <optional>

namespace placedpar::identification {

/// While a link's pressure moves too slowly over the window there is nothing to learn, and a search would follow the
/// noise: no generation is made. Too slowly is judged by the flow into the compliance, so that a soft hose, whose
/// pressure rises slowly, is let through.
struct ExcitationGate {
    double slope_psi_per_s = 800; ///< rms; ours: keeps 9 of 10 estimates within 10 % up to the mid noise

    /// The thesis's compliance: at it, slope and flow say the same.
    static constexpr double thesis_in3_per_psi = 0.0086;
    /// Of the slope, where nothing is known of the compliance yet: 150 psi/s, as for UsableSamples.
    static constexpr double first_share = 150. / 800;

    /// By the rms slope over a window, and the compliance that was found last.
    bool opens(double rms_psi_per_s, std::optional<double> compliance_in3_per_psi) const {
        if (!compliance_in3_per_psi)
            return rms_psi_per_s >= first_share * slope_psi_per_s;
        return rms_psi_per_s >= slope_psi_per_s ||
               rms_psi_per_s * *compliance_in3_per_psi >= slope_psi_per_s * thesis_in3_per_psi;
    }
    friend bool operator==(const ExcitationGate&, const ExcitationGate&) = default;
};

} // namespace placedpar::identification
