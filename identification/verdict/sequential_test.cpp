#include "identification/verdict/sequential_test.hpp"

#include <algorithm>

namespace placedpar::identification {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

Vector3d suspected(const Suspicion& suspicion, const Vector3d& scale) {
    const auto i = static_cast<Eigen::Index>(suspicion.way);
    Vector3d deviation = Vector3d::Zero();
    deviation[i] = scale[i] * suspicion.units;
    return deviation;
}

/// The logarithm of the likelihood of `suspected` over that of none.
double likelihood_ratio(const Vector3d& seen, const Matrix3d& information, const Vector3d& suspected) {
    return suspected.dot(information * (seen - suspected / 2));
}

/// The variance of one way, were the others known; none of what is known exactly.
double unknown_of(const Matrix3d& covariance, Way way) {
    const auto i = static_cast<Eigen::Index>(way);
    return covariance.isZero(0) ? 0 : 1 / covariance.inverse()(i, i);
}

} // namespace

double SequentialTest::add(std::size_t suspicion, const Vector3d& seen, const Matrix3d& information,
                           const Matrix3d& from_covariance, const Vector3d& scale) {
    double& sum = state_.sums[suspicion];
    double& known = state_.informations[suspicion];
    if (sum == 0)
        known = 0;
    const Vector3d by = suspected(suspicions[suspicion], scale);
    const double full = likelihood_ratio(seen, information, by);
    const double ratio = std::clamp(full, -most_of_one, most_of_one);
    known += by.dot(information * by) * (full == ratio ? 1 : ratio / full);
    const double worth = 1 + known * unknown_of(from_covariance, suspicions[suspicion].way) / by.squaredNorm();
    sum = std::clamp(sum + ratio, 0.0, most * worth);
    return sum / worth;
}

void SequentialTest::take(const Deviation& movement, const Deviation& from, const Vector3d& scale) {
    const Matrix3d information = movement.information();
    const Vector3d seen = movement.by - from.by;
    if (std::ranges::all_of(state_.sums, [](double sum) { return sum == 0; }))
        state_.total = {}, state_.movements = 0;
    double greatest = 0;
    for (std::size_t i = 0; i < suspicions.size(); ++i)
        greatest = std::max(greatest, add(i, seen, information, from.covariance, scale));
    state_.total.by += seen;
    state_.total.covariance += movement.covariance;
    ++state_.movements;
    state_.raised = greatest >= raised_at || (state_.raised && greatest > 0);
}

std::optional<Deviation> SequentialTest::mean() const {
    if (state_.movements == 0)
        return std::nullopt;
    const auto count = static_cast<double>(state_.movements);
    return Deviation{state_.total.by / count, state_.total.covariance / (count * count)};
}

} // namespace placedpar::identification
