#include "identification/verdict/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar::identification {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using hydraulics::AreasFrom;

namespace {

constexpr std::array<std::string_view, 8> verdict_names{
    "sound", "compliance", "leak", "offset", "drift", "sensor", "not enough evidence", "cannot tell"};

/// What a mean of many movements may still be off by, in units; ours.
constexpr double mean_repeats_within = 0.05;

/// Machines of a kind differ in health, in each way by this standard deviation, in units: 10 % of the compliance,
/// evenly.
constexpr double kind_within = 0.3;

Deviation kind_in_health() { return {Vector3d::Zero(), Matrix3d::Identity() * kind_within * kind_within}; }

VerdictKind kind_of(Way way, AreasFrom valve) {
    switch (way) {
    case Way::compliance: return VerdictKind::compliance;
    case Way::leak: return VerdictKind::leak;
    case Way::offset: break;
    }
    return valve == AreasFrom::servo ? VerdictKind::drift : VerdictKind::offset;
}

/// The greatest logarithm of likelihood, above that of sound, which a deviation in this way alone can give.
double explained_by(Way way, const Deviation& mean, const Matrix3d& information) {
    const auto i = static_cast<Eigen::Index>(way);
    const double pull = information.row(i) * mean.by;
    if (way == Way::leak && pull < 0)
        return 0; // a leak takes only
    return pull * pull / (2 * information(i, i));
}

/// Of sound and a link that is off by what is suspected, all equally likely before, the share of sound. Nobody suspects
/// an offset of areas that are read themselves.
double probability_sound(const Deviation& mean, const Matrix3d& information, AreasFrom valve) {
    double all = 1;
    for (const Suspicion& suspicion : SequentialTest::suspicions) {
        if (suspicion.way == Way::offset && valve == AreasFrom::areas)
            continue;
        Vector3d suspected = Vector3d::Zero();
        suspected[static_cast<Eigen::Index>(suspicion.way)] = suspicion.units;
        all += std::exp(suspected.dot(information * (mean.by - suspected / 2)));
    }
    return 1 / all;
}

/// Is it off in the way that is said by more than its standard error?
bool beyond_error(VerdictKind kind, const Deviation& mean, AreasFrom valve) {
    return std::ranges::any_of(all_ways, [&](Way way) {
        return kind_of(way, valve) == kind &&
               std::abs(mean.by[static_cast<Eigen::Index>(way)]) > mean.standard_error(way);
    });
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

Verdict verdict_of(const Deviation& mean, bool raised, AreasFrom valve) {
    Matrix3d covariance = mean.covariance;
    covariance.diagonal().array() += mean_repeats_within * mean_repeats_within;
    const Matrix3d information = covariance.inverse();
    if (!raised)
        return {VerdictKind::sound, probability_sound(mean, information, valve), mean, 0};
    std::array<double, all_ways.size()> explained{};
    std::ranges::transform(all_ways, explained.begin(), [&](Way way) { return explained_by(way, mean, information); });
    const auto best = std::ranges::max_element(explained);
    const double reach = *best;
    double all = std::exp(-reach); // sound
    for (double each : explained)
        all += std::exp(each - reach);
    return {kind_of(all_ways[static_cast<std::size_t>(best - explained.begin())], valve), 1 / all, mean, 0};
}

std::optional<Deviation> LinkJudge::baseline() const {
    if (state_.first.size() < movements_of_baseline)
        return std::nullopt;
    Matrix3d information = Matrix3d::Zero();
    Vector3d pull = Vector3d::Zero();
    for (const Deviation& each : state_.first) {
        const Matrix3d of_each = each.information();
        information += of_each;
        pull += of_each * each.by;
    }
    const Matrix3d covariance = information.inverse();
    return Deviation{covariance * pull, covariance};
}

bool LinkJudge::is_evidence(const Deviation& movement, AreasFrom valve) {
    return std::ranges::all_of(all_ways, [&](Way way) {
        return (way == Way::offset && valve == AreasFrom::areas) || movement.standard_error(way) <= most_uncertain;
    });
}

void LinkJudge::take(const Deviation& movement, AreasFrom valve) {
    if (!state_.impossible_now && !is_evidence(movement, valve))
        return;
    state_.impossible = std::exchange(state_.impossible_now, false);
    if (state_.impossible)
        return;
    if (valve != state_.valve)
        state_ = {}; // another way to know the valve has another offset in health
    state_.valve = valve;
    SequentialTest from_kind(state_.from_kind);
    from_kind.take(movement, kind_in_health(),
                   {valve == AreasFrom::servo ? servo_units_beyond_kind : units_beyond_kind, units_beyond_kind,
                    units_beyond_kind});
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
    if (!mean)
        return {};
    if (by_itself)
        mean->covariance += baseline()->covariance;
    Verdict verdict = verdict_of(*mean, test.raised(), state_.valve);
    if (test.raised() && !beyond_error(verdict.kind, *mean, state_.valve))
        verdict = {VerdictKind::cannot_tell, verdict_of(*mean, false, state_.valve).probability, *mean};
    if (verdict.kind == VerdictKind::sound && verdict.probability < least_sure_sound)
        verdict.kind = VerdictKind::cannot_tell;
    verdict.movements = test.state().movements;
    return verdict;
}

} // namespace placedpar::identification
