#include "app/experiment.hpp"
#include "app/single_link/boom_search.hpp"
#include "app/single_link/cells.hpp"
#include "app/single_link/pressure_check.hpp"
#include "app/single_link/spool_lag.hpp"
#include "hydraulics/steady_flow.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <optional>

namespace placedpar {

namespace {

constexpr double thesis_in3_per_psi = 0.0086, by_spool_in3_per_psi = 0.005;
constexpr double shown_s = 1.4;

IdentificationWay rising_way() {
    IdentificationWay way = thesis_way();
    way.usable.rising = true;
    return way;
}

/// The boom raised at another speed than scenario A's 4 deg/s, or at that.
BoomData motion_at(double deg_per_s, const SimpleMotion& sensors, const char* noise_name,
                   double compliance_in3_per_psi = thesis_in3_per_psi) {
    BoomScenario scenario;
    scenario.machine.inlet_compliance_in3_per_psi = compliance_in3_per_psi;
    double flow = deg_per_s * std::numbers::pi / 180 * scenario.machine.moment_arm_in * scenario.machine.inlet_area_in2;
    constexpr double steady_psi = 1850; // scenario A's
    if (deg_per_s != 4)
        scenario.spool_desired_in = boom_spool_for_flow(flow, steady_psi, scenario.flow);
    return simple_plant(scenario, sensors, noise_name);
}

/// The check of scenario A against figures of an independent prototype.
struct KnownCheck {
    double factor; // of the true compliance
    double rms_psi, tolerance_psi;
    std::optional<double> peak_psi;
};
const std::vector<KnownCheck>& known_checks() {
    static const std::vector<KnownCheck> all{{1, 1, 3, {}},
                                             {0.5, 134, 8, 2267},
                                             {2, 127, 8, 1883},
                                             {0.9, 19.5, 4, {}},
                                             {1.1, 19.5, 4, {}},
                                             {by_spool_in3_per_psi / thesis_in3_per_psi, 105, 6, {}}};
    return all;
}

Reading known_reading() {
    Reading reading{"scenario A without noise, its own pressure simulated again from the recorded spool and angle",
                    {}, "", "known", true};
    BoomData data = motion_at(4, {}, "no noise");
    for (const KnownCheck& known : known_checks()) {
        double compliance = known.factor * thesis_in3_per_psi;
        auto check = check_pressure(data, model_of(data, AreasFrom::spool), compliance);
        std::string row = fmt::format("C = {:.5f}", compliance);
        reading.cells.push_back(
            judged_cell(row, "rms difference", "psi", known.rms_psi, check.rms_psi, known.tolerance_psi, 1));
        reading.cells.push_back(known.peak_psi
                                    ? judged_cell(row, "peak", "psi", *known.peak_psi, check.peak_psi, 12, 0)
                                    : plain_cell(row, "peak", "psi", check.peak_psi, 0));
    }
    return reading;
}

/// The three curves of Figure 3.8.
struct Curve {
    const char* name;
    double factor;
};
constexpr std::array<Curve, 3> curves{{{"identified C", 1}, {"half of it", 0.5}, {"twice", 2}}};

/// One motion, simulated with the compliance that another one gave.
void add_motion(Reading& reading, double deg_per_s, const SimpleMotion& sensors, double identified_in3_per_psi) {
    BoomData data = motion_at(deg_per_s, sensors, "");
    for (const Curve& curve : curves) {
        auto check = check_pressure(data, model_of(data, AreasFrom::servo), curve.factor * identified_in3_per_psi);
        double percent = 100 * check.rms_psi / check.rise_psi;
        std::string row = fmt::format("{} deg/s, rms difference", deg_per_s);
        // "Excellent" is within the noise of the pressure and what 2 % of C make; "significant" 15 % of the rise.
        reading.cells.push_back(curve.factor == 1 ? judged_cell(row, curve.name, "psi", 0, check.rms_psi, 8, 1)
                                                  : plain_cell(row, curve.name, "psi", check.rms_psi, 1));
        reading.cells.push_back(plain_cell("  of the pressure's rise", curve.name, "%", percent, 1));
    }
}

} // namespace

Replay replay_figure_3_8(const ReplayContext&) { return {}; }

} // namespace placedpar
