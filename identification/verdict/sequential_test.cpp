#include "identification/verdict/sequential_test.hpp"

#include "identification/verdict/way_matrices.hpp"

#include <algorithm>

namespace placedpar::identification {

namespace {

WayVector suspected(const Suspicion& suspicion, const PerHypothesis& scale) {
    return suspicion.units * vector_of(unit_of(suspicion.fault)).cwiseProduct(vector_of(scale));
}

/// Returns the logarithm of the likelihood ratio of `suspected` to no deviation.
double likelihood_ratio(const WayVector& seen, const WayMatrix& information, const WayVector& suspected) {
    return suspected.dot(information * (seen - suspected / 2));
}

/// Models the uncertain reference as t * `by`, where t is a random number. Returns the variance of t that follows from
/// the covariance of the reference. Returns 0 if the reference is exact.
double unknown_of(const WayMatrix& covariance, const WayVector& by) {
    return covariance.isZero(0) ? 0 : 1 / by.dot(covariance.inverse() * by);
}

} // namespace

PerHypothesis unit_of(LinkFault fault) {
    PerHypothesis unit{};
    auto set = [&](FaultHypothesis way) { unit[index_of(way)] = 1; };
    switch (fault) {
    case LinkFault::compliance: set(FaultHypothesis::compliance); break;
    case LinkFault::leak: set(FaultHypothesis::leak_before); [[fallthrough]];
    case LinkFault::new_leak: set(FaultHypothesis::leak); break;
    case LinkFault::offset: set(FaultHypothesis::offset); break;
    }
    return unit;
}

double SequentialTest::add(std::size_t suspicion, const PerHypothesis& seen, const PerPairOfHypotheses& information,
                           const PerPairOfHypotheses& from_covariance, const PerHypothesis& scale) {
    double& sum = state_.sums[suspicion];
    double& known = state_.informations[suspicion];
    if (sum == 0)
        known = 0;
    const WayVector by = suspected(suspicions[suspicion], scale);
    const WayMatrix informed = matrix_of(information);
    const double full = likelihood_ratio(vector_of(seen), informed, by);
    const double ratio = std::clamp(full, -most_of_one, most_of_one);
    known += by.dot(informed * by) * (full == ratio ? 1 : ratio / full);
    const double worth = 1 + known * unknown_of(matrix_of(from_covariance), by);
    sum = std::clamp(sum + ratio, 0.0, most * worth);
    return sum / worth;
}

void SequentialTest::take(const Deviation& movement, const Deviation& from, const PerHypothesis& scale) {
    const PerPairOfHypotheses information = movement.information();
    const PerHypothesis seen = ways_of(vector_of(movement.by) - vector_of(from.by));
    if (std::ranges::all_of(state_.sums, [](double sum) { return sum == 0; }))
        state_.pull = {}, state_.information = {}, state_.movements = 0;
    double greatest = 0;
    for (std::size_t i = 0; i < suspicions.size(); ++i)
        greatest = std::max(greatest, add(i, seen, information, from.covariance, scale));
    const WayMatrix informed = matrix_of(information);
    state_.pull = ways_of(vector_of(state_.pull) + informed * vector_of(seen));
    state_.information = two_ways_of(matrix_of(state_.information) + informed);
    ++state_.movements;
    state_.raised = greatest >= raised_at || (state_.raised && greatest > 0);
}

std::optional<Deviation> SequentialTest::mean() const {
    if (state_.movements == 0)
        return std::nullopt;
    const WayMatrix covariance = matrix_of(state_.information).inverse();
    return Deviation{ways_of(covariance * vector_of(state_.pull)), two_ways_of(covariance)};
}

} // namespace placedpar::identification
