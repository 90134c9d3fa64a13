#include "identification/flags.hpp"

#include "hydraulics/circuit/line_fit.hpp"
#include "hydraulics/data/frozen_run.hpp"
#include "hydraulics/data/sampling.hpp"
#include "identification/compliance_fit.hpp"
#include "identification/spike.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

// An answer is flagged if both the slope of the pressure and the flow into the compliance are below these limits. Then,
// at medium noise, a third of the estimates are wrong by more than 10 %. The limits are half of those in
// ExcitationGate.
constexpr double least_slope_psi_per_s = 400, least_flow_in3_per_s = 3.4;
// A link is flagged if the compliances found in the two halves of the samples differ by more than this share of the
// answer.
constexpr double halves_differ = 0.3;
// The difference must also exceed this many standard errors, so that noise alone raises no flag.
constexpr double halves_differ_errors = 4;

/// Flags an answer at a bound of the search. Returns whether the answer was flagged.
bool flag_bounds(LinkIdentified& link, const CircuitProblem& problem) {
    double step = problem.field().resolution();
    bool low = at_lower_bound(link.compliance_in3_per_psi, step);
    bool high = at_upper_bound(link.compliance_in3_per_psi, step);
    if (low)
        link.flags.push_back(lower_bound_flag());
    if (high)
        link.flags.push_back(upper_bound_flag());
    return low || high;
}

bool flag_excitation(LinkIdentified& link, std::span<const CircuitSample> window, std::size_t junction) {
    double rms = excitation_psi_per_s(window, junction);
    bool still = rms < least_slope_psi_per_s && rms * link.compliance_in3_per_psi < least_flow_in3_per_s;
    if (still)
        link.flags.push_back(
            {FlagKind::no_excitation, fmt::format("no excitation: the pressure changes by {:.0f} psi/s (rms) over the "
                                                  "last window; below {:.0f} psi/s, noise determines the answer",
                                                  rms, least_slope_psi_per_s)});
    return still;
}

void flag_uncertainty(LinkIdentified& link) {
    if (link.of_all_samples)
        if (auto flag = unconfirmed_flag(link.compliance_in3_per_psi, *link.of_all_samples, "the same samples"))
            link.flags.push_back(*flag);
    if (link.standard_error > uncertain_share * link.compliance_in3_per_psi)
        link.flags.push_back(uncertain_flag(link.compliance_in3_per_psi, link.standard_error));
}

/// Flags a link if the reading of its valve never changes. A valve that has opened keeps moving, so the sensor must
/// have failed.
void flag_still_valve(LinkIdentified& link, std::span<const CircuitSample> samples, std::size_t junction, Side side) {
    auto area_in2 = [&](const CircuitSample& sample) {
        const LinkSample& read = sample.links[junction];
        return side == Side::inlet ? read.inlet_in2 : read.bypass_in2;
    };
    if (std::ranges::count(samples, area_in2(samples.front()), area_in2) == std::ssize(samples))
        link.flags.push_back({FlagKind::still_valve,
                              "inconsistent: the valve reading never changes, but the pressure changes as if the valve "
                              "moved"});
}

/// Flags pressures that are physically impossible.
void flag_pressure(LinkIdentified& link, std::span<const CircuitSample> samples, std::size_t junction) {
    std::vector<double> psi;
    for (const CircuitSample& sample : samples)
        psi.push_back(sample.links[junction].inlet_psi);
    if (double least = std::ranges::min(psi); least < vacuum_psi)
        link.flags.push_back(
            {FlagKind::vacuum, fmt::format("impossible: the pressure reads {:.0f} psi, below vacuum", least)});
    if (auto frozen = frozen_run(psi, least_jump_psi, fewest_frozen(method_period_s)))
        link.flags.push_back(
            {FlagKind::frozen, fmt::format("impossible: the pressure stays at {:.1f} psi for {} samples from {:.3f} "
                                           "s on, then jumps by {:.0f} psi",
                                           psi[frozen->first], frozen->last - frozen->first,
                                           samples[frozen->first].time_s, frozen->jump)});
}

/// Flags a link whose piston retracts on average over the samples, although the oil that flows in should extend the
/// piston.
void flag_falling(LinkIdentified& link, std::span<const CircuitSample> samples, std::size_t junction, Side side) {
    double flow = 0;
    for (const CircuitSample& sample : samples)
        flow += sample.links[junction].piston_flow_in3_per_s / static_cast<double>(samples.size());
    if (side == Side::outlet)
        flow = -flow;
    if (flow < -least_flow_in3_per_s)
        link.flags.push_back(
            {FlagKind::falls, fmt::format("inconsistent: the piston moves back, by {:.1f} in^3/s on average, while "
                                          "oil flows in: check the sign of the angle",
                                          -flow)});
}

/// Flags a link if the two halves of the samples give different compliances.
void flag_halves(LinkIdentified& link, const ComplianceFit& early, const ComplianceFit& late, std::size_t junction) {
    double difference = std::abs(late.compliance_in3_per_psi[junction] - early.compliance_in3_per_psi[junction]);
    double error = std::hypot(early.standard_error[junction], late.standard_error[junction]);
    if (difference > halves_differ * link.compliance_in3_per_psi && difference > halves_differ_errors * error)
        link.flags.push_back(
            {FlagKind::halves,
             fmt::format("inconsistent: least squares finds {:.5f} in^3/psi in the first half of the samples but "
                         "{:.5f} in^3/psi in the second",
                         early.compliance_in3_per_psi[junction], late.compliance_in3_per_psi[junction])});
}

} // namespace

bool LinkIdentified::flagged(FlagKind kind) const {
    return std::ranges::any_of(flags, [&](const Flag& flag) { return flag.kind == kind; });
}

bool Identified::flagged() const {
    return std::ranges::any_of(links, [](const LinkIdentified& link) { return !link.flags.empty(); });
}

void add_flags(Identified& identified, const CircuitProblem& problem, const FlowConstants& flow,
               std::span<const CircuitSample> samples, std::span<const CircuitSample> window,
               std::span<const CircuitSample> halved, const IdentificationWay& way) {
    std::vector<double> answer;
    for (const LinkIdentified& link : identified.links)
        answer.push_back(link.compliance_in3_per_psi);
    auto early = fit_compliances(identified.circuit, halved.first(halved.size() / 2), flow, answer);
    auto late = fit_compliances(identified.circuit, halved.subspan(halved.size() / 2), flow, answer);
    double allowed = std::sqrt(way.search.window.bias), error = identified.estimates.back().error_in3_per_s;
    for (std::size_t j = 0; j < identified.links.size(); ++j) {
        LinkIdentified& link = identified.links[j];
        bool at_bound = flag_bounds(link, problem), still = flag_excitation(link, window, j);
        if (error >= allowed)
            link.flags.push_back(
                {FlagKind::misfit, fmt::format("inconsistent: the flow error of the best individual is {:.1f} in^3/s "
                                               "(rms), more than the bias allows ({:.1f} in^3/s)",
                                               error, allowed)});
        flag_still_valve(link, samples, j, identified.circuit[j].side);
        flag_pressure(link, samples, j);
        flag_falling(link, samples, j, identified.circuit[j].side);
        if (early && late)
            flag_halves(link, *early, *late, j);
        if (!at_bound && !still)
            flag_uncertainty(link);
    }
}

void flag_spikes(Identified& identified, const Record& record, std::span<const CircuitSample> samples) {
    constexpr std::size_t reach = line_fit_points / 2;
    const Side side = identified.circuit.front().side, other = side == Side::inlet ? Side::outlet : Side::inlet;
    for (LinkIdentified& link : identified.links)
        for (Sensor sensor : all_sensors) {
            if (sensor == pressure_sensor(other) || !record.has(link.link, sensor))
                continue;
            const std::span<const double> readings = record.of(link.link, sensor);
            const double greatest = greatest_excursion(sensor, record.period_s);
            const std::size_t last = std::min(samples.back().index + reach, readings.size() - reach - 1);
            for (std::size_t i = std::max(samples.front().index, 2 * reach) - reach; i <= last; ++i)
                if (is_spike(readings.subspan(i - reach, line_fit_points), greatest)) {
                    link.flags.push_back(
                        {FlagKind::impossible,
                         fmt::format("impossible: {} reads {:g} at {:.3f} s, but {:g} just before and {:g} just "
                                     "after",
                                     name_of(sensor), readings[i], record.time_s[i], readings[i - 1],
                                     readings[i + 1])});
                    break;
                }
        }
}

void flag_calibration(Identified& identified, const SpoolOffset& found, double resolution_in) {
    constexpr double errors = 3;
    if (found.offset_in <= resolution_in + errors * found.deviation_in)
        return;
    auto boom = std::ranges::find(identified.links, Link::boom, &LinkIdentified::link);
    if (boom != identified.links.end())
        boom->flags.push_back(
            {FlagKind::offset,
             fmt::format("the calibration found an offset of {:+.4f} in, but a leak looks the "
                         "same; calibrate on a machine known to be sound, and give its offset with --offset",
                         found.offset_in)});
}

} // namespace placedpar::identification
