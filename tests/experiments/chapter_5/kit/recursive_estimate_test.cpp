// Tests recursive least squares with textbook examples, and both linear methods with plants of every delay.

#include "experiments/chapter_5/kit/least_squares.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

using namespace placedpar;

namespace {

using RecursionState = RecursiveEstimate<double>;

double take_one(RecursionState& estimate, double output, double forgetting = 1) {
    const std::array input{1.0};
    return estimate.take(input, output, forgetting);
}

/// A sequence of inputs of 1 and -1 without a short period: the signs of sin(k^2).
double sign_at(int k) { return std::sin(1.0 * k * k) < 0 ? -1 : 1; }

/// Returns samples as plant_record() has them, y(k), y(k-1), y(k-2), u(k-1), ..., u(k-6), of the plant
/// y(k) = 1.5 y(k-1) - .7 y(k-2) + u(k-d) + .5 u(k-d-1) + `third` u(k-d-2).
std::vector<Sample> samples_with_delay(int delay, int count, double third = 0) {
    double last = 0, before = 0;
    std::vector<Sample> samples;
    for (int k = 0; k < count; ++k) {
        const double output = 1.5 * last - 0.7 * before + sign_at(k - delay) + 0.5 * sign_at(k - delay - 1) +
                              third * sign_at(k - delay - 2);
        Sample sample{output, last, before};
        for (int past = 1; past <= 6; ++past)
            sample.push_back(sign_at(k - past));
        samples.push_back(sample);
        before = last;
        last = output;
    }
    return samples;
}

void check_weights(const LinearPlant& plant, const std::array<double, 5>& known, double epsilon) {
    for (std::size_t i = 0; i < known.size(); ++i) {
        CAPTURE(i);
        CHECK(std::abs(plant.weights[static_cast<Eigen::Index>(i)] - known[i]) < epsilon);
    }
}

} // namespace

TEST_CASE("with one unknown and no forgetting, the estimate is the mean of the outputs") {
    RecursionState estimate(1);
    double sum = 0, count = 0;
    for (double output : {2.0, 4.0, 9.0, -7.0}) {
        take_one(estimate, output);
        sum += output;
        // The first covariance, 1e6, counts as a millionth of an output of 0.
        CHECK(estimate.weights[0] == test::nearly(sum / (++count + 1e-6)));
        CHECK(estimate.covariance[0] == test::nearly(1 / (count + 1e-6)));
    }
    CHECK(estimate.weights[0] == test::nearly(2, 1e-6));
}

TEST_CASE("with forgetting, an output weighs half for each step of its age") {
    RecursionState estimate(1);
    for (double output : {8.0, 4.0, 1.0})
        take_one(estimate, output, 0.5);
    CHECK(estimate.weights[0] == test::nearly((8 * 0.25 + 4 * 0.5 + 1) / 1.75, 1e-5));
    for (int i = 0; i < 60; ++i)
        take_one(estimate, 5, 0.5);
    CHECK(estimate.weights[0] == test::nearly(5, 1e-12)); // the others are forgotten
}

TEST_CASE("take() returns the error of the prediction before the output is used") {
    RecursionState estimate(1);
    CHECK(take_one(estimate, 6) == 6); // nothing was known
    CHECK(take_one(estimate, 10) == test::nearly(4, 1e-5));
    CHECK(take_one(estimate, 8) == doctest::Approx(0).epsilon(1e-4));
}

TEST_CASE("a line through five points has the slope and the intercept of the textbook") {
    // The means are 3 and 3, the sum of products of deviations is 8, the sum of their squares 10.
    const std::array<double, 5> x{1, 2, 3, 4, 5}, y{1, 3, 2, 5, 4};
    RecursionState estimate(2);
    for (std::size_t i = 0; i < x.size(); ++i)
        estimate.take(std::array{x[i], 1.0}, y[i], 1);
    CHECK(estimate.weights[0] == test::nearly(0.8, 1e-4));
    CHECK(estimate.weights[1] == test::nearly(3 - 0.8 * 3, 1e-4));
    // The inverse of the sums ((55, 15), (15, 5)) is ((.1, -.3), (-.3, 1.1)).
    CHECK(estimate.covariance[0] == test::nearly(0.1, 1e-4));
    CHECK(estimate.covariance[1] == test::nearly(-0.3, 1e-4));
    CHECK(estimate.covariance[2] == estimate.covariance[1]);
    CHECK(estimate.covariance[3] == test::nearly(1.1, 1e-4));
}

TEST_CASE("the order of samples does not matter without forgetting") {
    RecursionState forwards(2), backwards(2);
    for (int i = 0; i < 20; ++i) {
        forwards.take(std::array{1.0 * i, 1.0}, std::cos(i), 1);
        backwards.take(std::array{19.0 - i, 1.0}, std::cos(19 - i), 1);
    }
    for (std::size_t i = 0; i < 2; ++i)
        CHECK(forwards.weights[i] == test::nearly(backwards.weights[i], 1e-6));
}

TEST_CASE("a sample without inputs teaches nothing, but time passes: the covariance grows by the forgetting") {
    RecursionState estimate(1);
    take_one(estimate, 3);
    const double weight = estimate.weights[0], covariance = estimate.covariance[0];
    CHECK(estimate.take(std::array{0.0}, 100, 0.8) == 100);
    CHECK(estimate.weights[0] == weight);
    CHECK(estimate.covariance[0] == test::nearly(covariance / 0.8));
}

TEST_CASE("the inputs of a delay are the two last outputs and three inputs from the delay on") {
    const Sample sample{0, 1, 2, 3, 4, 5, 6, 7, 8}; // y(k), y(k-1), y(k-2), u(k-1), ..., u(k-6)
    CHECK(LinearPlant::inputs(sample, 1) == LinearPlant::Coefficients(1., 2., 3., 4., 5.));
    CHECK(LinearPlant::inputs(sample, 4) == LinearPlant::Coefficients(1., 2., 6., 7., 8.));
}

TEST_CASE("the pole of a pair is that of thesis equation 5.9, and of real poles the greater one is reported") {
    const auto pole = [](double a1, double a2) {
        LinearPlant plant;
        plant.weights << a1, a2, 0, 0, 0;
        return plant.pole();
    };
    CHECK(pole(1.5, -0.7).alpha == 0.75);
    CHECK(pole(1.5, -0.7).beta == test::nearly(std::sqrt(0.7 - 0.75 * 0.75)));
    CHECK(pole(1.6, -0.64).alpha == test::nearly(0.8, 1e-6)); // a double pole
    CHECK(std::abs(pole(1.6, -0.64).beta) < 1e-7);
    CHECK(pole(-0.5, 0.14).alpha == test::nearly(0.2)); // .2 and -.7
    CHECK(pole(-0.5, 0.14).beta == 0);
}

TEST_CASE("least squares finds the delay and all coefficients of a plant without noise, whatever its delay is") {
    for (int delay : {1, 2, 3, 4}) {
        CAPTURE(delay);
        const LinearPlant plant = least_squares(samples_with_delay(delay, 40, 0.25));
        CHECK(plant.delay == static_cast<std::size_t>(delay));
        check_weights(plant, {1.5, -0.7, 1, 0.5, 0.25}, 1e-9);
        CHECK(plant.squared_error < 1e-18);
    }
}

TEST_CASE("the recursion finds the same plants, to the millionth of an output that it begins with") {
    for (int delay : {1, 2, 3, 4}) {
        CAPTURE(delay);
        RecursiveIdentification recursion(1);
        for (const Sample& sample : samples_with_delay(delay, 200, 0.25))
            recursion.push(sample);
        CHECK(recursion.plant().delay == static_cast<std::size_t>(delay));
        check_weights(recursion.plant(), {1.5, -0.7, 1, 0.5, 0.25}, 1e-4);
    }
}

TEST_CASE("fewer samples than coefficients are fitted exactly, by finite coefficients") {
    for (std::size_t samples : {1u, 2u, 4u}) {
        const std::vector<Sample> all = samples_with_delay(1, 60);
        const LinearPlant plant = least_squares(std::span(all).subspan(50, samples));
        CHECK(plant.squared_error < 1e-18);
        CHECK(plant.weights.allFinite());
        CHECK(plant.weights.norm() < 10);
    }
}

TEST_CASE("after a change, only a recursion that forgets finds the new plant") {
    const std::vector<Sample> before = samples_with_delay(1, 300), after = samples_with_delay(2, 100);
    RecursiveIdentification forgets(0.9), remembers(1);
    for (const std::vector<Sample>* part : {&before, &after})
        for (const Sample& sample : *part) {
            forgets.push(sample);
            remembers.push(sample);
        }
    CHECK(forgets.plant().delay == 2);
    check_weights(forgets.plant(), {1.5, -0.7, 1, 0.5, 0}, 1e-3);
    CHECK(std::abs(remembers.plant().weights[0] - 1.5) + std::abs(remembers.plant().weights[2] - 1) > 0.01);
}

TEST_CASE("the error of a recursion is the sum of its squared prediction errors, weighted by their age") {
    RecursiveLeastSquares recursion(1, 0.5);
    const Sample silent{0, 0, 0, 0, 0, 0, 0, 0, 0};
    Sample loud = silent;
    loud[0] = 3; // an output that no input explains
    recursion.push(loud);
    CHECK(recursion.plant().squared_error == 9);
    recursion.push(loud);
    CHECK(recursion.plant().squared_error == 9 * 0.5 + 9);
    recursion.push(silent);
    CHECK(recursion.plant().squared_error == (9 * 0.5 + 9) * 0.5);
}
