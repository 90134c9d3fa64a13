#include "experiments/chapter_3/kit/boom_plots.hpp"

#include "hydraulics/circuit/circuit_error.hpp"
#include "hydraulics/plant/excavator_record.hpp"

#include <algorithm>
#include <array>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

/// Returns a step curve in which each value is held until the next value.
Series held(Series series) {
    std::vector<Point> corners;
    for (const Point& point : series.points) {
        if (!corners.empty())
            corners.push_back({point.x, corners.back().y});
        corners.push_back(point);
    }
    series.points = corners;
    return series;
}

const std::vector<double>& of(const BoomData& data, Sensor sensor) { return data.record.of(Link::boom, sensor); }

Axis time_axis(double until_s) { return {"time [s]", 0, until_s}; }

Panel panel_over_time(std::string title, Axis y, double until_s, std::vector<Series> series) {
    return {std::move(title), time_axis(until_s), std::move(y), std::move(series)};
}

Panel pressure_panel(std::string title, const BoomData& data, double until_s) {
    return {std::move(title),
            time_axis(until_s),
            {"pressure [psi]", 0},
            {over_time("pump side", data.record.time_s, of(data, Sensor::inlet_pressure), until_s),
             over_time("drain side", data.record.time_s, of(data, Sensor::outlet_pressure), until_s)}};
}

Series velocity_series(const BoomData& data, const BoomModel& model, double until_s) {
    Series series{"velocity", {}};
    double flow_per_deg = calibrations_of(data, model)[index_of(Link::boom)].constants.piston_in3_per_deg();
    for (const CircuitSample& sample : samples_of(data, model))
        if (sample.time_s <= until_s)
            series.points.push_back({sample.time_s, sample.links[0].piston_flow_in3_per_s / flow_per_deg});
    return series;
}

Panel angle_panel(std::string title, const BoomData& data, double until_s) {
    Series angle = over_time("", data.record.time_s, of(data, Sensor::angle), until_s);
    double start = angle.points.front().y;
    for (Point& point : angle.points)
        point.y -= start;
    return {std::move(title), time_axis(until_s), {"angle, from its start [deg]"}, {angle}};
}

Panel velocity_panel(std::string title, const BoomData& data, const BoomModel& model, double until_s) {
    return {std::move(title), time_axis(until_s), {"velocity [deg/s]"}, {velocity_series(data, model, until_s)}};
}

Panel compliance_panel(const WatchedIdentification& watched, double until_s) {
    Series best{"best individual", {}};
    for (const TransientEstimate& estimate : watched.identified.found.estimates)
        best.points.push_back({estimate.time_s, 1000 * estimate.compliance_in3_per_psi[0]});
    best.points.push_back({until_s, best.points.back().y}); // the last answer is kept after the end of the search
    return {"c: estimated C_BOi",
            time_axis(until_s),
            {"compliance [0.001 in³/psi]", 0, 20},
            {best},
            {{"true", 1000 * watched.data.boom.inlet_compliance_in3_per_psi}}};
}

/// Returns the error of equation 3.8, with the compliance of the search's last answer, at every instant at which the
/// inlet is open.
Series error_of_answer(const WatchedIdentification& watched, double until_s) {
    Series series{"last answer", {}};
    const Circuit circuit = boom_circuit();
    const std::array answer{watched.identified.compliance_in3_per_psi};
    for (const CircuitSample& sample : samples_of(watched.data, watched.model))
        if (sample.time_s <= until_s && sample.links[0].inlet_in2 > 0) {
            double error = circuit_error_in3_per_s<double>(circuit, answer, sample.links, watched.data.flow,
                                                           printed_inlet_flow(1));
            series.points.push_back({sample.time_s, std::max(error, 0.01)});
        }
    return series;
}

Panel error_panel(const WatchedIdentification& watched, double until_s) {
    Series mean{"population's mean", {}}, best{"best one, rms", {}};
    double trials = 0; // the generations after a sample are spread over the sampling period
    for (std::size_t i = 0; i < watched.generations.size(); ++i) {
        const Generation& generation = watched.generations[i];
        trials = i > 0 && watched.generations[i - 1].time_s == generation.time_s ? trials + 1 : 0;
        double time_s = generation.time_s + trials * watched.data.record.period_s / 5;
        mean.points.push_back({time_s, generation.mean_error_in3_per_s});
        best.points.push_back({time_s, generation.best_error_in3_per_s});
    }
    return {"d: Error, equation 3.8",
            time_axis(until_s),
            {"Error [in³/s]", 0.01, 1000, true},
            {mean, best, error_of_answer(watched, until_s)}};
}

} // namespace

Series over_time(std::string name, std::span<const double> time_s, std::span<const double> values, double until_s,
                 Stroke stroke) {
    Series series{std::move(name), {}, stroke};
    for (std::size_t i = 0; i < values.size() && time_s[i] <= until_s; ++i)
        series.points.push_back({time_s[i], values[i]});
    return series;
}

Plot plot_of_record(std::string title, const BoomData& data, double until_s) {
    auto volts = held(over_time("asked for", data.record.time_s, of(data, Sensor::servo), until_s));
    auto spool = over_time("measured", data.record.time_s, of(data, Sensor::spool), until_s);
    auto lagged = over_time("A.1 and A.2", data.record.time_s, spool_of(data, model_of(data, AreasFrom::servo)),
                            until_s, Stroke::dashes);
    auto angle = over_time("measured", data.record.time_s, of(data, Sensor::angle), until_s);
    return {std::move(title),
            {pressure_panel("a: line pressures", data, until_s),
             panel_over_time("b: servo-valve's voltage", {"voltage [V]", 0, 0.4}, until_s, {volts}),
             panel_over_time("c: spool", {"spool [in]", 0.12, 0.28}, until_s, {spool, lagged}),
             panel_over_time("d: boom's angle", {"angle [deg]"}, until_s, {angle})}};
}

Plot plot_of_identification(const WatchedIdentification& watched, double until_s) {
    return {watched.title,
            {pressure_panel("a: line pressures", watched.data, until_s),
             angle_panel("b: boom's angle", watched.data, until_s),
             velocity_panel("b: boom's velocity", watched.data, watched.model, until_s),
             compliance_panel(watched, until_s), error_panel(watched, until_s)}};
}

} // namespace placedpar
