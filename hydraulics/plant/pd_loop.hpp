#pragma once

#include "hydraulics/data/parameters.hpp"

#include <array>
#include <complex>
#include <cstddef>
#include <optional>
#include <vector>

namespace placedpar::hydraulics {

/// The transfer function of a joint under P-D control (equation 2.9). It shows how a growing compliance C makes the
/// joint unstable. theta is the joint's angle and theta_d the demanded angle:
///     theta / theta_d = K_p a_0 / (s^3 + a_2 s^2 + (a_1 + a_0 K_v) s + K_p a_0)
struct PdLoop {
    double a0_per_s3; ///< 2 K_x D_m / (J C), a gain
    double a1_per_s2; ///< 2 D_m^2 / (J C); the thesis prints the terms of a_1 and a_2 exchanged
    double a2_per_s;  ///< K_pi / C
    double kp;        ///< proportional gain
    double kv_s;      ///< velocity gain
};

/// Returns the loop of Figures 2.8 and 2.9, with the constants of excavator.csv and the compliance C of Figure 2.8.
PdLoop reference_pd_loop(const Parameters& parameters = Parameters::excavator());

/// The physical quantities from which a_0, a_1 and a_2 follow, in SI units. The equations are J th'' = D_m P_L (two
/// chambers share the load pressure P_L), C P_L' = 2 K_x x - K_pi P_L - 2 D_m th' and x = K_p (th_d - th) - K_v th'. x
/// is the spool's displacement and th the joint's angle.
struct HydraulicJoint {
    double compliance_m3_per_pa;          ///< C
    double displacement_m3_per_rad;       ///< D_m
    double inertia_kg_m2;                 ///< J
    double flow_gain_m2_per_s;            ///< K_x, flow per spool displacement
    double flow_pressure_m3_per_s_per_pa; ///< K_pi
};

PdLoop pd_loop_of(const HydraulicJoint& joint, double kp, double kv_s);

/// Returns the loop with the compliance multiplied by `factor`; all three coefficients are proportional to 1 / C.
/// REQUIRES: factor > 0.
PdLoop with_compliance(const PdLoop& loop, double factor);

/// Returns the loop with a_1 and a_2 exchanged, as the thesis prints them. That form cannot be right, because a_2 s^2
/// and s^3 then have different dimensions.
PdLoop as_printed(const PdLoop& loop);

/// Returns the roots of the denominator, per second: the eigenvalues of its companion matrix, in order of increasing
/// real part. In a complex pair, the root below the real axis comes first.
std::array<std::complex<double>, 3> poles(const PdLoop& loop);

/// The oscillation that belongs to a pair of complex poles.
struct Oscillation {
    double damping;           ///< zeta; negative if the oscillation grows
    double natural_rad_per_s; ///< omega_n
};

/// Returns the oscillation of the loop; nullopt if all poles are real.
std::optional<Oscillation> oscillation(const PdLoop& loop);

/// Returns the ratio of Routh's criterion, a_2 (a_1 + a_0 K_v) / (K_p a_0). If this ratio exceeds 1, the loop is
/// stable. The ratio is proportional to 1 / C, so it is also the factor by which C may grow before the loop becomes
/// unstable. REQUIRES: all coefficients and gains > 0.
double stability_margin(const PdLoop& loop);

/// Returns the response theta to the step theta_d = 1 from rest, at the times 0, step_s, 2 step_s and so on. The values
/// are exact at these times (matrix exponential).
std::vector<double> step_response(const PdLoop& loop, double step_s, std::size_t count);

struct StepFigures {
    double overshoot_percent; ///< in percent of the final value 1; 0 if the response never exceeds 1
    double peak_time_s;       ///< time of the greatest value
    double settling_time_s;   ///< time from which the response stays within 2 % of the final value
};

/// Returns the figures of a step response. REQUIRES: the loop is stable and the response long enough to settle. Times
/// are whole multiples of step_s.
StepFigures figures_of(const std::vector<double>& response, double step_s);

} // namespace placedpar::hydraulics
