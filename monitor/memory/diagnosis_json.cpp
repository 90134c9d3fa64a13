#include "monitor/memory/diagnosis_json.hpp"

#include "identification/on_line/moving_diagnosis.hpp"
#include "monitor/memory/kept_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace placedpar::hydraulics {

BOOST_DESCRIBE_ENUM(Configuration, a, b, c, d, e)
BOOST_DESCRIBE_ENUM(AreasFrom, areas, spool, servo)
BOOST_DESCRIBE_STRUCT(FlowConstants, (), (orifice_in3_per_s_in2_sqrt_psi, pump_in3_per_s, tank_psi, relief_psi))
BOOST_DESCRIBE_STRUCT(LinkConstants, (), (piston_in3_per_rad, spool_lag_per_s))
BOOST_DESCRIBE_STRUCT(CircuitSample, (), (index, time_s, links, stretch))
BOOST_DESCRIBE_STRUCT(ValveLinks, (), (inlet_psi, inlet_in2, bypass_in2))
BOOST_DESCRIBE_STRUCT(ValveFlows, (), (inlet, bypass, relief))
BOOST_DESCRIBE_STRUCT(ValveReading, (), (links, piston_in3))
BOOST_DESCRIBE_STRUCT(ValveInterval, (), (end, configuration, junction_psi, mean, misfit, oil_in3_per_s, forward_s))
BOOST_DESCRIBE_STRUCT(ConfigurationWatch::State, (), (last, recent))
BOOST_DESCRIBE_STRUCT(LinkSample, (), (inlet_psi, inlet_slope_psi_per_s, piston_flow_in3_per_s, inlet_in2, bypass_in2))

} // namespace placedpar::hydraulics

namespace placedpar::identification {

BOOST_DESCRIBE_ENUM(AlarmKind, compliance, leak, offset, drift, leak_or_offset, sensor, branch)
BOOST_DESCRIBE_STRUCT(Alarm, (), (kind, links, text))
BOOST_DESCRIBE_STRUCT(ExcavatorParameters, (), (period_s, flow, links, compliance_in3_per_psi))
BOOST_DESCRIBE_STRUCT(OpenSample, (), (readings, first_s, after_s))
BOOST_DESCRIBE_STRUCT(LinkTrack::Sums, (), (inlet_psi, angle_deg, spool_in, inlet_in2, bypass_in2, readings, areas))
BOOST_DESCRIBE_STRUCT(LinkTrack::State, (), (inlet_psi, angle_deg, inlet_in2, bypass_in2, spool_in, desired_in, sums))
BOOST_DESCRIBE_STRUCT(LinkEstimate::State, (),
                      (recent_in3_per_psi, settled_in3_per_psi, standard_error_in3_per_psi, settled_error_in3_per_psi,
                       time_s, settled_time_s, excitation_psi_per_s, excited, fits, settled, generations_in_transient))
BOOST_DESCRIBE_STRUCT(PopulationSet::State, (), (population, window, to_skip, samples, generations, estimates))
BOOST_DESCRIBE_STRUCT(FrozenWatch::State, (), (last, equal, jump))
BOOST_DESCRIBE_STRUCT(MovementSamples, (), (at_rest, moving, rest_after))
BOOST_DESCRIBE_STRUCT(Movement::State, (), (samples, shut, opened, closed))
BOOST_DESCRIBE_STRUCT(Deviation, (), (by, covariance))
BOOST_DESCRIBE_STRUCT(SequentialTest::State, (), (sums, informations, raised, pull, information, movements))
BOOST_DESCRIBE_STRUCT(LinkJudge::State, (),
                      (first, from_itself, from_kind, valve, unexplained, impossible_now, impossible))
BOOST_DESCRIBE_STRUCT(SetWatch::State, (), (movement, valves, judges, moving_shut))
BOOST_DESCRIBE_STRUCT(ConfigurationSamples, (), (configuration, samples, weights))
BOOST_DESCRIBE_STRUCT(SetSearchState, (), (population, generations, drawn, rounds, fresh, configurations))
BOOST_DESCRIBE_STRUCT(PendingSample, (), (set, sample))
BOOST_DESCRIBE_STRUCT(MovingSearchState, (), (watch, readings, configuration, in_use, pending, next, searches))
BOOST_DESCRIBE_STRUCT(MovingDiagnosisState, (), (search, estimates, impossible))
BOOST_DESCRIBE_STRUCT(Diagnosis::State, (),
                      (name, parameters, configuration, active, time_s, time_may_restart, samples, open, sample_s,
                       tracks, sets, health_in3_per_psi, pressures, angles, watches, judged, alarms, moving))

} // namespace placedpar::identification

namespace placedpar::monitor {

using namespace hydraulics;
using namespace identification;

template <>
inline constexpr bool may_be_missing<std::optional<MovingDiagnosisState>> = true;

namespace {

void require_together(bool together, const char* what) {
    if (!together)
        throw std::runtime_error(fmt::format("the parts of {} do not fit together", what));
}

void require_whole(const LinkTrack::State& track, const Sampling& sampling) {
    const std::size_t size = track.inlet_psi.size();
    require_together(size <= line_fit_points && track.angle_deg.size() == size && track.inlet_in2.size() == size &&
                         track.bypass_in2.size() == size &&
                         track.spool_in.has_value() == track.desired_in.has_value() &&
                         track.sums.readings < sampling.readings,
                     "a link's readings");
}

/// Returns whether every sample has values of `links` links.
bool are_of(std::size_t links, const std::vector<SetSample>& samples) {
    return std::ranges::all_of(samples, [&](const SetSample& each) { return each.size() == links; });
}

void require_whole(LinkSet links, const PopulationSet::State& set, const DiagnosisSettings& settings) {
    if (set.population.size() != settings.search.population)
        throw std::runtime_error(fmt::format("a population has {} individuals, expected {}", set.population.size(),
                                             settings.search.population));
    const std::size_t bits = links.size() * settings.bits;
    require_together(std::ranges::all_of(set.population, [&](const Genome& each) { return each.size() == bits; }) &&
                         set.estimates.size() == links.size() && set.window.size() <= settings.search.window.length &&
                         are_of(links.size(), set.window),
                     "a population set");
}

void require_whole(std::size_t links, const Movement::State& movement, const Sampling& sampling) {
    const MovementSamples& samples = movement.samples;
    require_together(samples.moving.size() < sampling.samples_in(Movement::piece_s) &&
                         samples.at_rest.size() <= sampling.samples_in(Movement::rest_s) &&
                         samples.rest_after.size() <= sampling.samples_in(Movement::rest_after_s) &&
                         movement.shut.size() <= Movement::slope_reach && are_of(links, samples.moving) &&
                         are_of(links, samples.at_rest) && are_of(links, samples.rest_after) &&
                         are_of(links, movement.shut),
                     "a movement");
}

/// Throws std::runtime_error if a matrix that is inverted later has no inverse.
void require_invertible(const PerPairOfHypotheses& two, const char* what) {
    if (!has_inverse(two))
        throw std::runtime_error(fmt::format("{} has no inverse", what));
}

void require_invertible(const LinkJudge::State& judge) {
    for (const Deviation& each : judge.first)
        require_invertible(each.covariance, "the covariance of a movement");
    for (const SequentialTest::State* test : {&judge.from_itself, &judge.from_kind})
        if (test->movements > 0)
            require_invertible(test->information, "the information of a test");
}

void require_whole(LinkSet links, const SetWatch::State& watch, const Sampling& sampling) {
    require_whole(links.size(), watch.movement, sampling);
    require_together(watch.valves.size() == links.size() && watch.judges.size() == links.size() &&
                         watch.moving_shut.size() == links.size() &&
                         std::ranges::all_of(watch.judges,
                                             [](const LinkJudge::State& judge) {
                                                 return judge.first.size() <= LinkJudge::movements_of_baseline;
                                             }),
                     "a watched set");
    for (const LinkJudge::State& judge : watch.judges)
        require_invertible(judge);
}

bool are_coupled(Configuration configuration, LinkSet links) {
    return std::ranges::any_of(coupled_groups(configuration),
                               [&](LinkSet group) { return !links.empty() && (links & group) == links; });
}

bool are_of(std::size_t links, const std::vector<CircuitSample>& samples) {
    return std::ranges::all_of(samples, [&](const CircuitSample& each) { return each.links.size() == links; });
}

void require_whole(LinkSet links, const SetSearchState& search) {
    const IdentificationWay way = whole_way(links.size()).way;
    const std::size_t bits = links.size() * way.bits;
    std::size_t samples = 0;
    for (const ConfigurationSamples& each : search.configurations) {
        samples += each.samples.size();
        require_together(are_coupled(each.configuration, links) && are_of(links.size(), each.samples),
                         "the samples of a configuration");
    }
    require_together(
        search.population.size() == way.search.population && samples <= MovingDiagnosis::most_samples &&
            std::ranges::all_of(search.population, [&](const Genome& each) { return each.size() == bits; }) &&
            (search.rounds == 0 || samples > 0),
        "the search of a set");
}

bool is_finite(const PerLink<double>& values) {
    return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

void require_whole(const ConfigurationWatch::State& watch) {
    const ValveInterval& last = watch.last;
    require_together(watch.recent.size() <= ConfigurationWatch::span + 1 &&
                         (watch.recent.empty() || watch.recent.back() == last) && is_finite(last.junction_psi) &&
                         is_finite(last.oil_in3_per_s) && is_finite(last.forward_s) &&
                         is_finite(last.end.links.inlet_psi) && is_finite(last.end.piston_in3),
                     "the recognised configuration");
}

void require_whole(const MovingDiagnosisState& moving) {
    for (const auto& [links, search] : moving.search.searches)
        require_whole(links, search);
    for (const PendingSample& each : moving.search.pending)
        require_together(are_coupled(moving.search.configuration, each.set) &&
                             each.sample.links.size() == each.set.size(),
                         "a sample that waits");
    for (const auto& [links, estimates] : moving.estimates) {
        auto search = moving.search.searches.find(links);
        require_together(
            search != moving.search.searches.end() && search->second.rounds > 0 && estimates.size() == links.size() &&
                std::ranges::all_of(estimates,
                                    [](const LinkEstimate& each) { return each.compliance_in3_per_psi().has_value(); }),
            "the estimates of a set");
    }
    require_whole(moving.search.watch);
    require_together(std::ranges::none_of(moving.search.in_use, &LinkSet::empty), "the recognised configuration");
}

void require_whole(const Diagnosis::State& state, const DiagnosisSettings& settings) {
    const Sampling sampling = Sampling::of(state.parameters.period_s);
    if (state.open.readings >= sampling.readings)
        throw std::runtime_error("the unfinished sample already has all its readings");
    for (const LinkTrack& track : state.tracks)
        require_whole(track.state(), sampling);
    for (const auto& [links, set] : state.sets)
        require_whole(links, set, settings);
    for (const auto& [links, watch] : state.watches)
        require_whole(links, watch, sampling);
    if (!state.moving)
        return;
    require_whole(*state.moving);
    require_together(MovingDiagnosis::suits(sampling.period_s()) &&
                         state.configuration == state.moving->search.configuration &&
                         (state.time_s || state.moving->estimates.empty()),
                     "the recognised configuration");
}

} // namespace

boost::json::value state_json(const Diagnosis::State& state) { return KeptJson::write(state); }

Diagnosis::State state_from(const boost::json::value& value, const DiagnosisSettings& settings) {
    try {
        Diagnosis::State state;
        KeptJson::read(state, value);
        require_whole(state, settings);
        return state;
    } catch (const NotWhole& wrong) {
        throw std::runtime_error(fmt::format("the state is incomplete or wrong: {}: {}", wrong.path, wrong.what()));
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("the state is incomplete or wrong: {}", error.what()));
    }
}

} // namespace placedpar::monitor
