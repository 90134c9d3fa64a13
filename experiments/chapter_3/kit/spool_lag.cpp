#include "experiments/chapter_3/kit/spool_lag.hpp"

#include "text/user_error.hpp"

#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>

namespace placedpar {

using namespace hydraulics;

namespace {

std::optional<double> found_with(const BoomModel& model, const BoomData& data) {
    UsableSamples rising;
    rising.rising = true;
    return least_squares_compliance(data, model, rising);
}

BoomModel with_lag(double lag_per_s) { return {AreasFrom::servo, lag_per_s, 0}; }

/// Returns the a_0 between `low` and `high` at which the rising function `found` equals the compliance.
template <class Found>
double solve(double compliance_in3_per_psi, double low, double high, double precision, Found found) {
    auto beyond = [&](double x) {
        auto value = found(x);
        if (!value)
            throw UserError(fmt::format("no sample is usable with a_0 = {} 1/s", x));
        return *value - compliance_in3_per_psi;
    };
    if (beyond(low) > 0 || beyond(high) < 0)
        throw UserError(fmt::format("no a_0 from {} to {} 1/s makes the identification find {} in^3/psi", low, high,
                                    compliance_in3_per_psi));
    // The set of usable samples changes with x, so the function has jumps. Of the root finders, bisection tolerates
    // jumps best.
    auto [below, above] =
        boost::math::tools::bisect(beyond, low, high, [=](double a, double b) { return b - a < precision; });
    return (below + above) / 2;
}

Series series_over_lag(const BoomData& machine) {
    Series series{fmt::format("true C {}", machine.boom.inlet_compliance_in3_per_psi)};
    for (int i = 0; i <= 110; ++i)
        if (auto found = found_with(with_lag(5 + 0.1 * i), machine))
            series.points.push_back({5 + 0.1 * i, 1000 * *found});
    return series;
}

} // namespace

double lag_that_finds(double compliance_in3_per_psi, const BoomData& data) {
    double own = data.boom.spool_lag_per_s;
    return solve(compliance_in3_per_psi, 0.75 * own, 4 * own, 1e-3,
                 [&](double lag) { return found_with(with_lag(lag), data); });
}

Panel panel_of_lag(std::span<const BoomData> machines) {
    Panel panel{"Compliance identified from the voltage, over the assumed a_0",
                {"a_0 of A.2 [1/s]", 5, 16},
                {"compliance [0.001 in³/psi]", 0, 20},
                {},
                {{"thesis, spool", 5}, {"thesis, voltage", 8.6}}};
    for (const BoomData& machine : machines) {
        panel.series.push_back(series_over_lag(machine));
        int colour = static_cast<int>(panel.series.size()) - 1;
        panel.series.push_back({"  its own a_0",
                                {{machine.boom.spool_lag_per_s, 1000 * machine.boom.inlet_compliance_in3_per_psi}},
                                Stroke::points,
                                colour});
    }
    return panel;
}

} // namespace placedpar
