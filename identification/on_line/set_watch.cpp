#include "identification/on_line/set_watch.hpp"

#include "hydraulics/circuit/circuit_sample.hpp"
#include "hydraulics/circuit/junction_flow.hpp"
#include "identification/verdict/movement_fit.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

/// If a piston on average pushes out more oil than this limit while oil should flow in, the angle's reading has the
/// wrong sign (our choice).
constexpr double least_inflow_in3_per_s = 1;

/// If more oil than this limit flows into the cylinder and its hose, the oil moves the piston, and not the load (our
/// choice).
constexpr double driven_in3_per_s = 10;
/// A boom that swings after its valve has shut swings back within this time, in seconds.
constexpr double longest_swing_s = 0.5;

/// Returns whether the movement determines the size of this deviation.
bool tells(const Deviation& deviation, FaultHypothesis way) {
    return deviation.standard_error(way) <= LinkJudge::most_uncertain;
}

/// Returns whether a deviation is physically impossible: the compliance is below 0 by more than two standard errors, or
/// the spool offset exceeds .05 in by more than two standard errors.
bool impossible(const Deviation& found, AreasFrom valve) {
    const Deviation deviation = found.with_steady_leak();
    constexpr double no_compliance = -1 / WayUnits::compliance_share, furthest_offset = 10, errors = 2;
    const double compliance = deviation.by[index_of(FaultHypothesis::compliance)];
    const double offset = std::abs(deviation.by[index_of(FaultHypothesis::offset)]);
    const bool tells_offset = valve == AreasFrom::areas || tells(deviation, FaultHypothesis::offset);
    return (tells_offset && tells(deviation, FaultHypothesis::compliance) &&
            compliance + errors * deviation.standard_error(FaultHypothesis::compliance) < no_compliance) ||
           (valve == AreasFrom::spool && tells_offset &&
            offset - errors * deviation.standard_error(FaultHypothesis::offset) > furthest_offset);
}

/// Returns for each link of the set whether oil can flow into its cylinder, even if the pressure reads somewhat too
/// high. In a circuit of outlets, only the valve decides.
std::vector<bool> where_oil_enters(const SetProblem& problem, const SetSample& sample) {
    std::vector<bool> enters(sample.size());
    const JunctionSamples links = problem.by_junction(sample);
    std::vector<JunctionOpening> openings;
    for (const LinkSample& link : links)
        openings.push_back(
            {link.inlet_psi - Movement::open_by_psi, std::max(link.inlet_in2, 0.0), std::max(link.bypass_in2, 0.0)});
    const std::vector<JunctionFlow> flows = solve_junctions(problem.circuit(), openings, problem.flow());
    const bool is_inlet = problem.circuit().front().side == Side::inlet;
    for (std::size_t j = 0; j < links.size(); ++j)
        enters[problem.positions()[j]] = is_inlet ? flows[j].inlet_in3_per_s > 0 : links[j].inlet_in2 > 0;
    return enters;
}

/// Returns whether the readings of a movement make no sense: a reading never changes, or a piston retracts while oil
/// flows in.
bool senseless(const MovementSamples& movement, std::size_t junction) {
    bool frozen = true;
    double flow_in3_per_s = 0;
    for (const JunctionSamples& samples : movement.moving) {
        frozen = frozen && samples[junction].inlet_psi == movement.moving.front()[junction].inlet_psi;
        flow_in3_per_s += samples[junction].piston_flow_in3_per_s / static_cast<double>(movement.moving.size());
    }
    return frozen || flow_in3_per_s < -least_inflow_in3_per_s;
}

} // namespace

SetWatch::State SetWatch::first_state(LinkSet links) {
    return {{},
            std::vector<AreasFrom>(links.size()),
            std::vector<LinkJudge::State>(links.size()),
            std::vector<std::size_t>(links.size())};
}

SetWatch::Judged SetWatch::take(const SetProblem& problem, const SetSample& sample, std::span<const AreasFrom> valves,
                                std::span<const double> health_in3_per_psi) {
    std::ranges::copy(valves, state_.valves.begin());
    Movement movement(sampling_, std::move(state_.movement));
    const bool over = movement.take(problem.circuit(), problem.flow(), problem.by_junction(sample));
    state_.movement = movement.state();
    return over ? judge_movement(problem, health_in3_per_psi) : std::nullopt;
}

bool SetWatch::note_moving_shut(const SetProblem& problem, const SetSample& sample,
                                std::span<const double> health_in3_per_psi) {
    bool noted = false;
    std::optional<std::vector<bool>> enters;
    for (std::size_t i = 0; i < sample.size(); ++i) {
        const LinkSample& link = sample[i];
        const double flow =
            cylinder_flow(link.piston_flow_in3_per_s, link.inlet_slope_psi_per_s, health_in3_per_psi[i]);
        std::size_t& count = state_.moving_shut[i];
        const bool moves = flow > driven_in3_per_s;
        if (moves && !enters)
            enters = where_oil_enters(problem, sample);
        count = moves && !(*enters)[i] ? count + 1 : 0;
        if (count != sampling_.samples_in(longest_swing_s))
            continue;
        note_impossible(i);
        noted = true;
    }
    return noted;
}

SetWatch::Judged SetWatch::end_movement(const SetProblem& problem, std::span<const double> health_in3_per_psi) {
    std::ranges::fill(state_.moving_shut, 0);
    return judge_movement(problem, health_in3_per_psi);
}

SetWatch::Judged SetWatch::judge_movement(const SetProblem& problem, std::span<const double> health_in3_per_psi) {
    Movement movement(sampling_, std::move(state_.movement));
    const MovementSamples samples = movement.finish();
    state_.movement = movement.state();
    std::vector<LinkInHealth> by_junction;
    for (std::size_t position : problem.positions())
        by_junction.push_back({health_in3_per_psi[position], state_.valves[position]});
    auto found = fit_movement(problem.circuit(), problem.flow(), by_junction, samples);
    if (!found)
        return std::nullopt;
    Judged judged(found->links.size());
    note_senseless(problem, samples, found->links);
    for (std::size_t j = 0; j < found->links.size(); ++j) {
        const std::size_t position = problem.positions()[j];
        LinkJudge judge(std::move(state_.judges[position]));
        judge.take(found->links[j], state_.valves[position], found->misfit);
        state_.judges[position] = judge.state();
        (*judged)[position] = found->links[j];
    }
    return judged;
}

void SetWatch::note_impossible(std::size_t position) {
    LinkJudge judge(std::move(state_.judges[position]));
    judge.note_impossible();
    state_.judges[position] = judge.state();
}

void SetWatch::note_senseless(const SetProblem& problem, const MovementSamples& movement,
                              std::span<const Deviation> deviations) {
    for (std::size_t j = 0; j < problem.positions().size(); ++j)
        if (senseless(movement, j) || impossible(deviations[j], state_.valves[problem.positions()[j]]))
            note_impossible(problem.positions()[j]);
}

} // namespace placedpar::identification
