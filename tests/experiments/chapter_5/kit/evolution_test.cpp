// Tests differential evolution and CMA-ES on objectives with a known optimum.

#include "experiments/chapter_5/kit/covariance_adaptation.hpp"
#include "experiments/chapter_5/kit/differential_evolution.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;

namespace {

double sphere(const Eigen::VectorXd& x) { return (x - Eigen::VectorXd::Constant(x.size(), 0.3)).squaredNorm(); }

/// A long valley across the axes, with axis lengths from 1 to 1000.
double ellipse(const Eigen::VectorXd& x) {
    Eigen::VectorXd from = x - Eigen::VectorXd::Constant(x.size(), 0.6);
    double along = from.sum(), sum = along * along / static_cast<double>(x.size());
    return sum * 1e-6 + (from.squaredNorm() - sum);
}

/// A slope with its optimum in a corner of the cube.
double slope(const Eigen::VectorXd& x) { return x.sum(); }

} // namespace

TEST_CASE("differential evolution finds the minimum of a sphere, and of a slope in a corner") {
    for (auto objective : {sphere, slope}) {
        DifferentialEvolution evolution(6, 40, RandomStream(1, "test"));
        evolution.evaluate(objective);
        for (int i = 0; i < 400; ++i)
            evolution.next_generation(objective);
        CHECK(objective(evolution.best()) < 1e-6);
        CHECK(evolution.best().minCoeff() >= 0);
    }
}

TEST_CASE("a generation of differential evolution never makes the best individual worse") {
    DifferentialEvolution evolution(6, 10, RandomStream(2, "test"));
    evolution.evaluate(ellipse);
    for (double best = ellipse(evolution.best()); best > 1e-3; best = ellipse(evolution.best())) {
        evolution.next_generation(ellipse);
        CHECK(ellipse(evolution.best()) <= best);
    }
}

TEST_CASE("CMA-ES finds the minimum of a sphere, of a valley of ratio 1000, and in a corner") {
    for (auto objective : {sphere, ellipse, slope}) {
        CovarianceAdaptation strategy(6, 12, 0, RandomStream(1, "test"));
        for (int i = 0; i < 400; ++i)
            strategy.next_generation(objective);
        CHECK(objective(strategy.mean()) < 1e-8);
    }
}

TEST_CASE("CMA-ES follows a moving optimum only with a least step") {
    auto distance = [](double least_step) {
        CovarianceAdaptation strategy(6, 12, least_step, RandomStream(1, "test"));
        double at = 0.2;
        auto moving = [&](const Eigen::VectorXd& x) {
            return std::abs(x[0] - at) + (x.tail(5).array() - 0.5).matrix().norm();
        };
        for (int i = 0; i < 1000; ++i)
            strategy.next_generation(moving);
        at = 0.8;
        for (int i = 0; i < 60; ++i)
            strategy.next_generation(moving);
        return std::abs(strategy.mean()[0] - at);
    };
    CHECK(distance(0.02) < 0.05);
    CHECK(distance(0) > 0.3);
}

TEST_CASE("a generation evaluates one value for each point, all inside the cube") {
    std::size_t asked = 0;
    bool inside = true;
    auto corner = [&](const Eigen::VectorXd& point) {
        ++asked;
        inside = inside && point.minCoeff() >= 0 && point.maxCoeff() <= 1;
        return -point.sum();
    };
    DifferentialEvolution evolution(3, 8, RandomStream(1, "test"));
    evolution.evaluate(corner);
    for (int generation = 0; generation < 20; ++generation)
        evolution.next_generation(corner);
    CHECK(asked == 8 + 20 * 8);
    asked = 0;
    CovarianceAdaptation adaptation(3, 8, 0, RandomStream(1, "test"));
    for (int generation = 0; generation < 20; ++generation)
        adaptation.next_generation(corner);
    CHECK(asked == 20 * 8);
    CHECK(inside);
}
