#include "hydraulics/circuit/circuit_sample.hpp"

#include "hydraulics/circuit/boom_orifices.hpp"
#include "hydraulics/circuit/junction_flow.hpp"
#include "hydraulics/circuit/line_fit.hpp"
#include "hydraulics/circuit/voltage_spool.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace placedpar::hydraulics {

namespace {

std::vector<OrificeAreas> areas_as_read(const Record& record, Link link) {
    std::vector<OrificeAreas> areas;
    for (std::size_t i = 0; i < record.size(); ++i)
        areas.push_back({record.of(link, Sensor::inlet_area)[i], record.of(link, Sensor::bypass_area)[i], 0});
    return areas;
}

std::vector<double> spool_by_voltage(const Record& record, Link link, double spool_lag_per_s) {
    return spool_from_volts(record.of(link, Sensor::servo), record.time_s, spool_lag_per_s, record.period_s);
}

std::vector<OrificeAreas> areas_of(const Record& record, Link link, AreasFrom from,
                                   const LinkCalibration& calibration) {
    if (from == AreasFrom::areas)
        return areas_as_read(record, link);
    std::vector<double> spool = from == AreasFrom::spool
                                    ? record.of(link, Sensor::spool)
                                    : spool_by_voltage(record, link, calibration.constants.spool_lag_per_s);
    std::vector<OrificeAreas> areas;
    for (double spool_in : spool) // sensor noise may make spool_in slightly negative
        areas.push_back(boom_orifices(std::max(spool_in - calibration.spool_offset_in, 0.0)));
    return areas;
}

/// One side of a link in the record: its readings and its areas.
struct LinkChannels {
    Side side;
    const std::vector<double>&psi, &angle_deg;
    std::vector<OrificeAreas> areas;
    double piston_in3_per_deg;
};

LinkChannels channels_of(const Record& record, const Junction& junction, const LinkCalibration& calibration) {
    const auto [link, side] = std::pair(junction.link, junction.side);
    const AreasFrom from = areas_from(record.channels(), link, calibration.from, side);
    require_channels(record, link, from, side);
    return {side, record.of(link, pressure_sensor(side)), record.of(link, Sensor::angle),
            areas_of(record, link, from, calibration), calibration.constants.piston_in3_per_deg()};
}

LinkSample sample_at(const LinkChannels& link, const CentredLineFit& fit, std::size_t i) {
    const OrificeAreas& areas = link.areas[i];
    const bool drain = link.side == Side::outlet;
    return {link.psi[i], fit.slope_per_s(link.psi, i), link.piston_in3_per_deg * fit.slope_per_s(link.angle_deg, i),
            drain ? std::numeric_limits<double>::infinity() : areas.inlet_in2,
            drain ? areas.outlet_in2 : areas.bypass_in2};
}

} // namespace

std::vector<double> CircuitSample::values() const {
    std::vector<double> values;
    for (const LinkSample& link : links)
        values.insert(values.end(), {link.inlet_psi, link.inlet_slope_psi_per_s, link.piston_flow_in3_per_s,
                                     link.inlet_in2, link.bypass_in2});
    return values;
}

std::vector<CircuitSample> circuit_samples(const Record& record, const Circuit& circuit,
                                           const LinkCalibrations& calibrations) {
    std::vector<LinkChannels> links;
    for (const Junction& junction : circuit)
        links.push_back(channels_of(record, junction, calibrations[index_of(junction.link)]));
    std::vector<CircuitSample> samples;
    if (record.size() == 0)
        return samples;
    CentredLineFit fit(record.period_s);
    constexpr std::size_t side = line_fit_points / 2;
    std::vector<Stretch> stretches = record.stretches();
    for (std::size_t s = 0; s < stretches.size(); ++s)
        for (std::size_t i = stretches[s].first + side; i + side < stretches[s].last; ++i) {
            CircuitSample sample{i, record.time_s[i], {}, s};
            for (const LinkChannels& link : links)
                sample.links.push_back(sample_at(link, fit, i));
            samples.push_back(std::move(sample));
        }
    return samples;
}

bool all_open(const Circuit& circuit, std::span<const LinkSample> links, const FlowConstants& flow, double margin_psi) {
    if (circuit.front().side == Side::outlet)
        return std::ranges::all_of(links, [&](const LinkSample& link) {
            return link.bypass_in2 > 0 && link.inlet_psi - margin_psi > flow.tank_psi;
        });
    std::vector<JunctionOpening> openings;
    for (const LinkSample& link : links)
        openings.push_back({link.inlet_psi + margin_psi, link.inlet_in2, link.bypass_in2});
    return std::ranges::all_of(solve_junctions(circuit, openings, flow),
                               [](const JunctionFlow& junction) { return junction.inlet_in3_per_s > 0; });
}

double excitation_psi_per_s(std::span<const CircuitSample> samples, std::size_t junction) {
    double squares = 0;
    for (const CircuitSample& sample : samples) {
        double slope = sample.links[junction].inlet_slope_psi_per_s;
        squares += slope * slope;
    }
    return std::sqrt(squares / static_cast<double>(samples.size()));
}

std::vector<CircuitSample> usable_samples(std::span<const CircuitSample> samples, const Circuit& circuit,
                                          const FlowConstants& flow, const UsableSamples& rule) {
    auto starts = [&](const CircuitSample& sample) {
        return all_open(circuit, sample.links, flow, rule.open_by_psi) &&
               std::ranges::all_of(sample.links, [&](const LinkSample& link) {
                   return link.inlet_slope_psi_per_s > rule.first_slope_psi_per_s;
               });
    };
    auto falls = [&](const CircuitSample& sample) {
        return rule.rising &&
               std::ranges::any_of(sample.links, [](const LinkSample& link) { return link.inlet_slope_psi_per_s < 0; });
    };
    std::vector<CircuitSample> usable;
    std::size_t skipped = 0;
    for (auto sample = std::ranges::find_if(samples, starts); sample != samples.end(); ++sample) {
        if (usable.size() == rule.count || falls(*sample))
            break;
        if (all_open(circuit, sample->links, flow, 0) && skipped++ >= rule.skipped)
            usable.push_back(*sample);
    }
    return usable;
}

} // namespace placedpar::hydraulics
