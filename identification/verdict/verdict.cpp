#include "identification/verdict/verdict.hpp"

#include "identification/verdict/mean_deviation.hpp"
#include "identification/verdict/way_matrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar::identification {

using hydraulics::AreasFrom;

namespace {

constexpr std::array<std::string_view, 9> verdict_names{
    "sound", "compliance", "leak", "offset", "drift", "leak or offset", "sensor", "not enough evidence", "cannot tell"};

/// The standard error that remains in a mean over very many movements, in the units of WayUnits; our choice.
constexpr double mean_repeats_within = 0.05;

/// The standard deviation, in the units of WayUnits, by which healthy machines of one kind differ in each of the ways
/// of Deviation. For the compliance, it is about the standard deviation of a uniform distribution within 10 % of the
/// mean.
constexpr double kind_within = 0.3;

/// Returns the distribution of the deviations of healthy machines of one kind. The small leak of a healthy link hardly
/// changes when the valve opens, so the leaks before and during a movement are correlated.
Deviation kind_in_health() {
    constexpr double leak_in_common = 0.9;
    WayMatrix covariance = WayMatrix::Identity() * kind_within * kind_within;
    const Eigen::Index before = row_of(FaultHypothesis::leak_before), during = row_of(FaultHypothesis::leak);
    covariance(before, during) = covariance(during, before) = leak_in_common * kind_within * kind_within;
    return {{}, two_ways_of(covariance)};
}

/// Returns the information, the inverse of the covariance, of a mean over movements. The information does not exceed a
/// limit, however many movements there are.
WayMatrix information_of_mean(const Deviation& mean) {
    WayMatrix covariance = matrix_of(mean.covariance);
    covariance.diagonal().array() += mean_repeats_within * mean_repeats_within;
    return covariance.inverse();
}

/// The most likely size of one fault as the only cause of a mean deviation.
struct Explanation {
    FaultSize size;
    double likelihood; ///< logarithm of the likelihood, relative to a sound link
};

Explanation explanation_by(LinkFault fault, const Deviation& mean, const WayMatrix& information) {
    const WayVector unit = vector_of(unit_of(fault)), weights = information * unit;
    const double known = weights.dot(unit), pull = weights.dot(vector_of(mean.by));
    const bool takes_only = fault == LinkFault::leak || fault == LinkFault::new_leak;
    return {{pull / known, 1 / std::sqrt(known)}, takes_only && pull < 0 ? 0 : pull * pull / (2 * known)};
}

/// The posterior probabilities of a sound link and of each fault. The two leaks count as one fault.
struct Shares {
    double sound, compliance, leak, offset;
};

Shares shares_of(const Deviation& mean, const WayMatrix& information) {
    auto of = [&](LinkFault fault) { return explanation_by(fault, mean, information).likelihood; };
    const double compliance = of(LinkFault::compliance), leak = std::max(of(LinkFault::leak), of(LinkFault::new_leak)),
                 offset = of(LinkFault::offset), reach = std::max({compliance, leak, offset});
    Shares shares{std::exp(-reach), std::exp(compliance - reach), std::exp(leak - reach), std::exp(offset - reach)};
    const double all = shares.sound + shares.compliance + shares.leak + shares.offset;
    return {shares.sound / all, shares.compliance / all, shares.leak / all, shares.offset / all};
}

/// Returns the posterior probability that the link is sound, with equal priors for a sound link and for each suspected
/// fault. If the areas were measured directly, no offset is suspected.
double probability_sound(const Deviation& mean, const WayMatrix& information, AreasFrom valve) {
    double all = 1;
    for (const Suspicion& suspicion : SequentialTest::suspicions) {
        if (suspicion.fault == LinkFault::offset && valve == AreasFrom::areas)
            continue;
        const WayVector suspected = suspicion.units * vector_of(unit_of(suspicion.fault));
        all += std::exp(suspected.dot(information * (vector_of(mean.by) - suspected / 2)));
    }
    return 1 / all;
}

/// Returns whether the size of the verdict's fault exceeds its standard error.
bool beyond_error(VerdictKind kind, const Deviation& mean) {
    auto alone = [&](FaultHypothesis way) {
        const FaultSize size = size_alone(way, mean);
        return std::abs(size.by) > size.standard_error;
    };
    switch (kind) {
    case VerdictKind::compliance:
        return std::abs(mean.by[index_of(FaultHypothesis::compliance)]) >
               mean.standard_error(FaultHypothesis::compliance);
    case VerdictKind::leak: return alone(FaultHypothesis::leak);
    case VerdictKind::leak_or_offset: return alone(FaultHypothesis::leak) && alone(FaultHypothesis::offset);
    default: return alone(FaultHypothesis::offset);
    }
}

/// Returns the deviation with the covariance that the noise of the readings alone would give it.
Deviation without_misfit(Deviation movement, double misfit) {
    for (double& each : movement.covariance)
        each /= misfit;
    return movement;
}

} // namespace

std::string_view name_of(VerdictKind kind) { return verdict_names[static_cast<std::size_t>(kind)]; }

std::string how_sure(double probability) {
    return probability > 0.99 ? "more than 99 % sure" : fmt::format("{:.0f} % sure", 100 * probability);
}

std::optional<VerdictKind> verdict_named(std::string_view name) {
    auto found = std::ranges::find(verdict_names, name);
    if (found == verdict_names.end())
        return std::nullopt;
    return static_cast<VerdictKind>(found - verdict_names.begin());
}

FaultSize size_alone(FaultHypothesis way, const Deviation& mean) {
    const WayMatrix information = information_of_mean(mean);
    if (way == FaultHypothesis::offset)
        return explanation_by(LinkFault::offset, mean, information).size;
    const Explanation steady = explanation_by(LinkFault::leak, mean, information),
                      begun = explanation_by(LinkFault::new_leak, mean, information);
    return steady.likelihood >= begun.likelihood ? steady.size : begun.size;
}

std::string print_leak_or_offset(const Deviation& mean, const WayUnits& units) {
    const FaultSize leak = size_alone(FaultHypothesis::leak, mean), offset = size_alone(FaultHypothesis::offset, mean);
    return fmt::format(
        "either a leak of {:.4f} in^3/(s psi) (standard error {:.4f} in^3/(s psi)), or a spool {:+.4f} in lower "
        "than its sensor or the voltage says (standard error {:.4f} in): readings at rest under pressure, before "
        "the movement and for .4 s after it, would distinguish the two",
        units.leak_in3_per_s_psi * leak.by, units.leak_in3_per_s_psi * leak.standard_error, units.offset_in * offset.by,
        units.offset_in * offset.standard_error);
}

Verdict verdict_of(const Deviation& mean, bool raised, AreasFrom valve) {
    constexpr double told_apart = 0.9;
    const WayMatrix information = information_of_mean(mean);
    if (!raised)
        return {VerdictKind::sound, probability_sound(mean, information, valve), mean, 0};
    const Shares shares = shares_of(mean, information);
    const double either = shares.leak + shares.offset, likelier = std::max(shares.leak, shares.offset);
    if (shares.compliance >= likelier)
        return {VerdictKind::compliance, shares.compliance, mean, 0};
    if (likelier < told_apart * either && valve != AreasFrom::areas && size_alone(FaultHypothesis::leak, mean).by > 0)
        return {VerdictKind::leak_or_offset, either, mean, 0};
    if (shares.leak >= shares.offset)
        return {VerdictKind::leak, shares.leak, mean, 0};
    return {valve == AreasFrom::servo ? VerdictKind::drift : VerdictKind::offset, shares.offset, mean, 0};
}

std::optional<Deviation> LinkJudge::baseline() const {
    if (state_.first.size() < movements_of_baseline)
        return std::nullopt;
    return mean_deviation(state_.first);
}

bool LinkJudge::is_evidence(const Deviation& movement, AreasFrom valve) {
    const Deviation steady = movement.with_steady_leak();
    auto told = [&](FaultHypothesis way) { return steady.standard_error(way) <= most_uncertain; };
    return told(FaultHypothesis::compliance) && told(FaultHypothesis::leak) &&
           (valve == AreasFrom::areas || told(FaultHypothesis::offset));
}

void LinkJudge::take(const Deviation& movement, AreasFrom valve, double misfit) {
    if (!state_.impossible_now && !is_evidence(movement, valve)) {
        state_.unexplained += misfit > greatest_misfit && is_evidence(without_misfit(movement, misfit), valve);
        return;
    }
    state_.unexplained = 0;
    state_.impossible = std::exchange(state_.impossible_now, false);
    if (state_.impossible)
        return;
    if (valve != state_.valve)
        state_ = {}; // a healthy link has another offset with another source of the areas
    state_.valve = valve;
    SequentialTest from_kind(state_.from_kind);
    from_kind.take(movement, kind_in_health(),
                   {valve == AreasFrom::servo ? servo_units_beyond_kind : units_beyond_kind, units_beyond_kind,
                    units_beyond_kind, units_beyond_kind});
    state_.from_kind = from_kind.state();
    const auto healthy = baseline();
    if (!healthy) {
        state_.first.push_back(movement);
        return;
    }
    SequentialTest from_itself(state_.from_itself);
    from_itself.take(movement, *healthy);
    state_.from_itself = from_itself.state();
}

Verdict LinkJudge::verdict() const {
    if (state_.impossible)
        return {VerdictKind::sensor, 1, {}, 0};
    const SequentialTest from_itself(state_.from_itself), from_kind(state_.from_kind);
    const bool by_itself = from_itself.raised() || !from_kind.raised();
    const SequentialTest& test = by_itself ? from_itself : from_kind;
    auto mean = test.mean();
    const bool is_unexplained = !test.raised() && state_.unexplained >= most_unexplained;
    if (is_unexplained)
        return {.kind = VerdictKind::sensor, .probability = 1, .deviation = {}, .unexplained = state_.unexplained};
    if (!mean)
        return {};
    if (by_itself)
        mean->covariance = two_ways_of(matrix_of(mean->covariance) + matrix_of(baseline()->covariance));
    Verdict verdict = verdict_of(*mean, test.raised(), state_.valve);
    if (test.raised() && !beyond_error(verdict.kind, *mean))
        verdict = {VerdictKind::cannot_tell, verdict_of(*mean, false, state_.valve).probability, *mean};
    if (verdict.kind == VerdictKind::sound && verdict.probability < least_sure_sound)
        verdict.kind = VerdictKind::cannot_tell;
    verdict.movements = test.state().movements;
    return verdict;
}

} // namespace placedpar::identification
