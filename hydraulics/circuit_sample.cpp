#include "hydraulics/circuit_sample.hpp"

#include "hydraulics/boom_orifices.hpp"
#include "hydraulics/line_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace placedpar {

namespace {

/// A link's channels in the record.
struct LinkChannels {
    const std::vector<double>&inlet_psi, &angle_deg, &spool_in, &inlet_in2, &bypass_in2;
    const LinkReading& reading;

    bool areas_were_read() const { return !inlet_in2.empty() && !bypass_in2.empty(); }
};

void require(const Record& record, MachineLink link, Sensor sensor) {
    if (!record.has(link, sensor))
        throw std::invalid_argument(fmt::format("the record has no channel {}.{}", name_of(link), name_of(sensor)));
}

LinkChannels channels_of(const Record& record, MachineLink link, const LinkReading& reading) {
    LinkChannels channels{record.of(link, Sensor::inlet_pressure), record.of(link, Sensor::angle),
                          record.of(link, Sensor::spool),          record.of(link, Sensor::inlet_area),
                          record.of(link, Sensor::bypass_area),    reading};
    require(record, link, Sensor::inlet_pressure);
    require(record, link, Sensor::angle);
    if (!channels.areas_were_read())
        require(record, link, Sensor::spool);
    return channels;
}

/// The spool, where the areas come from it; sensor noise may take it a little below 0.
double spool_in(const LinkChannels& link, std::size_t i) {
    return std::max(link.spool_in[i] - link.reading.spool_offset_in, 0.0);
}

LinkSample sample_at(const LinkChannels& link, const CentredLineFit& fit, std::size_t i) {
    OrificeAreas areas = link.areas_were_read() ? OrificeAreas{link.inlet_in2[i], link.bypass_in2[i], 0}
                                                : boom_orifices(spool_in(link, i));
    return {link.inlet_psi[i], fit.slope_per_s(link.inlet_psi, i),
            link.reading.piston_flow_in3_per_deg * fit.slope_per_s(link.angle_deg, i), areas.inlet_in2,
            areas.bypass_in2};
}

double square(double x) { return x * x; }

} // namespace

std::vector<double> CircuitSample::values() const {
    std::vector<double> values;
    for (const LinkSample& link : links)
        values.insert(values.end(), {link.inlet_psi, link.inlet_slope_psi_per_s, link.piston_flow_in3_per_s,
                                     link.inlet_in2, link.bypass_in2});
    return values;
}

std::vector<CircuitSample> circuit_samples(const Record& record, const Circuit& circuit, const LinkReadings& readings) {
    std::vector<LinkChannels> links;
    for (const Junction& junction : circuit)
        links.push_back(channels_of(record, junction.link, readings[index_of(junction.link)]));
    std::vector<CircuitSample> samples;
    if (record.size() == 0)
        return samples;
    CentredLineFit fit(record.period_s);
    constexpr std::size_t side = line_fit_points / 2;
    for (Stretch stretch : record.stretches())
        for (std::size_t i = stretch.first + side; i + side < stretch.last; ++i) {
            CircuitSample sample{i, record.time_s[i], {}};
            for (const LinkChannels& link : links)
                sample.links.push_back(sample_at(link, fit, i));
            samples.push_back(std::move(sample));
        }
    return samples;
}

double open_by_psi(const Circuit& circuit, std::span<const LinkSample> links, const FlowConstants& flow) {
    std::array<double, all_links.size()> passing{}, psi{};
    for (std::size_t j = 0; j < circuit.size(); ++j) {
        passing[j] += circuit[j].pumps * flow.pump_in3_per_s;
        if (circuit[j].through == Through::junction)
            passing[circuit[j].next] += passing[j];
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = circuit.size(); j-- > 0;) {
        double below = circuit[j].through == Through::junction ? psi[circuit[j].next] : flow.tank_psi;
        psi[j] = circuit[j].through == Through::nowhere
                     ? std::numeric_limits<double>::infinity()
                     : below + square(passing[j] / (flow.orifice_in3_per_s_in2_sqrt_psi * links[j].bypass_in2));
        least = std::min(least, psi[j] - links[j].inlet_psi);
    }
    return least;
}

double excitation_psi_per_s(std::span<const CircuitSample> samples, std::size_t junction) {
    double squares = 0;
    for (const CircuitSample& sample : samples)
        squares += square(sample.links[junction].inlet_slope_psi_per_s);
    return std::sqrt(squares / static_cast<double>(samples.size()));
}

std::vector<CircuitSample> usable_samples(std::span<const CircuitSample> samples, const Circuit& circuit,
                                          const FlowConstants& flow, const UsableSamples& rule) {
    auto open = [&](const CircuitSample& sample, double by_psi) {
        return std::ranges::all_of(sample.links, [](const LinkSample& link) { return link.inlet_in2 > 0; }) &&
               open_by_psi(circuit, sample.links, flow) > by_psi;
    };
    auto starts = [&](const CircuitSample& sample) {
        return open(sample, rule.open_by_psi) && std::ranges::all_of(sample.links, [&](const LinkSample& link) {
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
        if (open(*sample, 0) && skipped++ >= rule.skipped)
            usable.push_back(*sample);
    }
    return usable;
}

} // namespace placedpar
