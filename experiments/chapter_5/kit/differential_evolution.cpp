#include "experiments/chapter_5/kit/differential_evolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace placedpar {

namespace {

double reflected(double x) {
    x = std::fmod(std::abs(x), 2.0);
    return x > 1 ? 2 - x : x;
}

Eigen::VectorXd random_point(std::size_t dimensions, RandomStream& random) {
    Eigen::VectorXd point(static_cast<Eigen::Index>(dimensions));
    for (double& x : point)
        x = random.uniform();
    return point;
}

std::array<std::size_t, 3> three_others(std::size_t than, std::size_t of, RandomStream& random) {
    std::array<std::size_t, 3> others{than, than, than};
    for (std::size_t i = 0; i < others.size();) {
        std::size_t drawn = random.below(static_cast<std::uint32_t>(of));
        if (drawn != than && std::find(others.begin(), others.begin() + i, drawn) == others.begin() + i)
            others[i++] = drawn;
    }
    return others;
}

} // namespace

DifferentialEvolution::DifferentialEvolution(std::size_t dimensions, std::size_t population, RandomStream random)
    : random_(std::move(random)), values_(population) {
    for (std::size_t i = 0; i < population; ++i)
        points_.push_back(random_point(dimensions, random_));
}

void DifferentialEvolution::evaluate(const Objective01& minimised) {
    for (std::size_t i = 0; i < points_.size(); ++i)
        values_[i] = minimised(points_[i]);
}

Eigen::VectorXd DifferentialEvolution::trial(std::size_t of) {
    auto [a, b, c] = three_others(of, points_.size(), random_);
    Eigen::VectorXd trial = points_[of];
    Eigen::Index always = random_.below(static_cast<std::uint32_t>(trial.size()));
    for (Eigen::Index i = 0; i < trial.size(); ++i)
        if (random_.chance(crossover) || i == always)
            trial[i] = reflected(points_[a][i] + weight * (points_[b][i] - points_[c][i]));
    return trial;
}

void DifferentialEvolution::next_generation(const Objective01& minimised) {
    std::vector<Eigen::VectorXd> trials;
    for (std::size_t i = 0; i < points_.size(); ++i)
        trials.push_back(trial(i));
    for (std::size_t i = 0; i < points_.size(); ++i)
        if (double value = minimised(trials[i]); value <= values_[i]) {
            points_[i] = std::move(trials[i]);
            values_[i] = value;
        }
}

const Eigen::VectorXd& DifferentialEvolution::best() const {
    return points_[static_cast<std::size_t>(std::ranges::min_element(values_) - values_.begin())];
}

} // namespace placedpar
