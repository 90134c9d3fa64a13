#include "app/single_link/spool_lag.hpp"

#include <boost/math/tools/roots.hpp>
#include <fmt/format.h>

#include <stdexcept>

namespace placedpar {

namespace {

std::optional<double> found_with(double lag_per_s, const BoomData& data) {
    UsableSamples rising;
    rising.rising = true;
    return least_squares_compliance(data, {AreasFrom::servo, lag_per_s, 0}, rising);
}

} // namespace

double lag_that_finds(double compliance_in3_per_psi, const BoomData& data) {
    auto beyond = [&](double lag_per_s) {
        auto found = found_with(lag_per_s, data);
        if (!found)
            throw std::runtime_error(fmt::format("a_0 = {} 1/s leaves no usable samples", lag_per_s));
        return *found - compliance_in3_per_psi;
    };
    double low = 0.75 * data.machine.spool_lag_per_s, high = 4 * data.machine.spool_lag_per_s;
    if (beyond(low) > 0 || beyond(high) < 0)
        throw std::runtime_error(fmt::format("no a_0 finds {} in^3/psi", compliance_in3_per_psi));
    // The usable samples change with a_0, which makes the function jump: bisection minds least.
    auto [below, above] =
        boost::math::tools::bisect(beyond, low, high, [](double a, double b) { return b - a < 1e-3; });
    return (below + above) / 2;
}

Panel panel_of_lag(std::span<const BoomData> machines) {
    Panel panel{"Compliance that the voltage gives, over the a_0 believed in",
                {"a_0 of A.2 [1/s]", 5, 16},
                {"compliance [0.001 in³/psi]", 0, 20},
                {},
                {{"thesis, spool", 5}, {"thesis, voltage", 8.6}}};
    for (const BoomData& machine : machines) {
        Series series{fmt::format("true C {}", machine.machine.inlet_compliance_in3_per_psi), {}};
        for (int i = 0; i <= 110; ++i)
            if (auto found = found_with(5 + 0.1 * i, machine))
                series.points.push_back({5 + 0.1 * i, 1000 * *found});
        panel.series.push_back(series);
        panel.series.push_back(
            {"  its own a_0",
             {{machine.machine.spool_lag_per_s, 1000 * machine.machine.inlet_compliance_in3_per_psi}},
             Stroke::points,
             static_cast<int>(panel.series.size()) - 1});
    }
    return panel;
}

} // namespace placedpar
