// Tests properties and limits of differential evolution and CMA-ES: what they depend on, and their smallest sizes.

#include "experiments/chapter_5/kit/covariance_adaptation.hpp"
#include "experiments/chapter_5/kit/differential_evolution.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace placedpar;

namespace {

double bowl(const Eigen::VectorXd& x) { return (x.array() - 0.4).matrix().squaredNorm(); }

/// Returns the best points of `generations` generations.
std::vector<Eigen::VectorXd> course_of_evolution(const Objective01& objective, int generations,
                                                 std::uint64_t seed = 1) {
    DifferentialEvolution evolution(3, 12, RandomStream(seed, "test"));
    evolution.evaluate(objective);
    std::vector<Eigen::VectorXd> course{evolution.best()};
    for (int i = 0; i < generations; ++i) {
        evolution.next_generation(objective);
        course.push_back(evolution.best());
    }
    return course;
}

/// Returns the distances of the mean from the middle of the bowl after each generation.
std::vector<double> distances_of_means(std::size_t dimensions, std::size_t population, int generations) {
    CovarianceAdaptation strategy(dimensions, population, 0, RandomStream(1, "test"));
    std::vector<double> distances{std::sqrt(bowl(strategy.mean()))};
    for (int i = 0; i < generations; ++i) {
        strategy.next_generation(bowl);
        distances.push_back(std::sqrt(bowl(strategy.mean())));
    }
    return distances;
}

} // namespace

TEST_CASE("differential evolution depends only on the order of values, and on its seed") {
    const auto course = course_of_evolution(bowl, 30),
               same = course_of_evolution([](const Eigen::VectorXd&x) { return std::exp(bowl(x)) - 5; }, 30);
    for (std::size_t i = 0; i < course.size(); ++i)
        CHECK(course[i] == same[i]);
    CHECK(course_of_evolution(bowl, 0, 2).front() != course.front());
}

TEST_CASE("differential evolution keeps what it has if every change is worse, and moves on a plain") {
    int asked = 0; // the first population has falling values, the trials are all worse
    const auto course = course_of_evolution([&](const Eigen::VectorXd&) { return ++asked <= 12 ? -asked : asked; }, 10);
    CHECK(course.back() == course.front());
    const auto plain = course_of_evolution([](const Eigen::VectorXd&) { return 1; }, 10);
    CHECK(plain.back() != plain.front()); // a trial that is not worse is taken
}

TEST_CASE("a changed objective must be evaluated anew, or the old values keep the old points") {
    DifferentialEvolution evolution(2, 20, RandomStream(1, "test"));
    evolution.evaluate(bowl);
    for (int i = 0; i < 5; ++i)
        evolution.next_generation(bowl);
    const auto moved = [](const Eigen::VectorXd& x) { return 1 + (x.array() - 0.8).matrix().squaredNorm(); };
    const Eigen::VectorXd before = evolution.best();
    evolution.next_generation(moved); // each trial is worse than every value that is kept
    CHECK(evolution.best() == before);
    evolution.evaluate(moved);
    for (int i = 0; i < 150; ++i)
        evolution.next_generation(moved);
    CHECK(moved(evolution.best()) < 1 + 1e-4);
}

TEST_CASE("four points in one dimension are enough for both methods") {
    DifferentialEvolution evolution(1, 4, RandomStream(3, "test"));
    evolution.evaluate(bowl);
    const double first = bowl(evolution.best());
    for (int i = 0; i < 60; ++i)
        evolution.next_generation(bowl);
    CHECK(bowl(evolution.best()) <= first);
    CHECK(distances_of_means(1, 4, 60).back() < 1e-3);
}

TEST_CASE("CMA-ES begins in the middle of the cube, whatever its seed is") {
    for (std::uint64_t seed : {1u, 2u})
        CHECK(CovarianceAdaptation(4, 8, 0, RandomStream(seed, "test")).mean() == Eigen::VectorXd::Constant(4, 0.5));
}

TEST_CASE("on a bowl the distance of CMA-ES falls by the same factor in equal numbers of generations") {
    const std::vector<double> distances = distances_of_means(6, 12, 300);
    const double first = std::log(distances[50] / distances[150]), second = std::log(distances[150] / distances[250]);
    CHECK(first > 3); // at least a factor of 20 in a hundred generations
    CHECK(second == doctest::Approx(first).epsilon(0.25));
}

TEST_CASE("a plain gives CMA-ES no direction: its mean stays finite and in the cube") {
    CovarianceAdaptation strategy(5, 10, 0, RandomStream(1, "test"));
    for (int i = 0; i < 500; ++i)
        strategy.next_generation([](const Eigen::VectorXd&) { return 0; });
    CHECK(strategy.mean().allFinite());
    CHECK(strategy.mean().minCoeff() >= 0);
    CHECK(strategy.mean().maxCoeff() <= 1);
}

TEST_CASE("an optimum outside the cube is answered by the nearest corner") {
    CovarianceAdaptation strategy(3, 10, 0, RandomStream(1, "test"));
    const auto beyond = [](const Eigen::VectorXd& x) { return (x.array() - 2).matrix().squaredNorm(); };
    for (int i = 0; i < 300; ++i)
        strategy.next_generation(beyond);
    CHECK((strategy.mean() - Eigen::VectorXd::Ones(3)).norm() < 1e-4);
}

TEST_CASE("with a least step the points of CMA-ES stay spread by it, without one they fall together") {
    const auto spread_after = [](double least_step) {
        CovarianceAdaptation strategy(2, 20, least_step, RandomStream(1, "test"));
        for (int i = 0; i < 200; ++i)
            strategy.next_generation(bowl);
        double least = std::numeric_limits<double>::infinity(), greatest = 0;
        strategy.next_generation([&](const Eigen::VectorXd& x) {
            least = std::min(least, x[0]);
            greatest = std::max(greatest, x[0]);
            return bowl(x);
        });
        return greatest - least;
    };
    CHECK(spread_after(0.02) > 0.01); // of 20 points with a deviation of up to .02
    CHECK(spread_after(0.02) < 0.2);
    CHECK(spread_after(0) < 1e-6);
}
