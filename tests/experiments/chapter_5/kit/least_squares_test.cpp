// Tests recursive least squares against the plant, a batch solution with the same samples, and every string.

#include "experiments/chapter_5/kit/least_squares.hpp"
#include "gaprocs/representation/genome.hpp"
#include "problems/plant/plant_problem.hpp"
#include "runtime/random.hpp"
#include "text/statistics.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace placedpar;

namespace {

std::vector<Sample> record(double noise, std::uint64_t seed = 1, std::array<double, 2> colour = {},
                           std::size_t generations = 900) {
    PlantExperiment experiment{
        .change = PlantChange::none, .noise = noise, .colour = colour, .generations = generations};
    return plant_record(experiment, RandomStream(seed, "plant"));
}

double distance_from_truth(Pole pole) {
    Pole truth = pole_of(Plant{}.a1, Plant{}.a2);
    return std::hypot(pole.alpha - truth.alpha, pole.beta - truth.beta);
}

/// Returns the sum of squared prediction errors of the parameters in a string.
double squared_error(const PlantProblem& problem, const Genome& genome, std::span<const Sample> window) {
    double sum = 0;
    for (const Sample& sample : window)
        sum += problem.error(genome, sample) * problem.error(genome, sample);
    return sum;
}

} // namespace

TEST_CASE("without noise the plant is found exactly, from ten samples on") {
    auto samples = record(0);
    for (std::size_t window : {10u, 30u, 100u}) {
        LinearPlant found = least_squares(std::span(samples).first(window));
        CHECK(found.delay == 1);
        CHECK(distance_from_truth(found.pole()) < 1e-9);
        CHECK(found.squared_error < 1e-18);
    }
}

TEST_CASE("of two real poles the one nearer to 1 is reported") {
    LinearPlant plant;
    plant.weights << 0.9 + 0.5, -0.9 * 0.5, 1, 0, 0; // (z - .9)(z - .5)
    CHECK(plant.pole().alpha == doctest::Approx(0.9));
    CHECK(plant.pole().beta == 0);
}

TEST_CASE("no string of the search space predicts better than least squares") {
    PlantProblem problem;
    RandomStream random(3, "strings");
    for (double noise : {0.1, 1.0}) {
        auto samples = record(noise);
        auto window = std::span<const Sample>(samples).subspan(20, 30);
        double least = least_squares(window).squared_error;
        for (int i = 0; i < 2000; ++i)
            CHECK(squared_error(problem, Genome::random(problem.bits(), random), window) >= least);
    }
}

TEST_CASE("recursive least squares without forgetting equals least squares over all samples") {
    auto samples = record(0.3);
    RecursiveIdentification recursive(1);
    for (const Sample& sample : samples)
        recursive.push(sample);
    LinearPlant batch = least_squares(samples);
    CHECK(recursive.plant().delay == batch.delay);
    for (Eigen::Index i = 0; i < batch.weights.size(); ++i)
        CHECK(recursive.plant().weights[i] == doctest::Approx(batch.weights[i]).epsilon(1e-5));
}

TEST_CASE("recursive least squares with forgetting .9 does not diverge over ten thousand samples") {
    RecursiveIdentification recursive(0.9);
    for (const Sample& sample : record(0.3, 1, {}, 30000))
        recursive.push(sample);
    CHECK(distance_from_truth(recursive.plant().pole()) < 0.3);
}

TEST_CASE("coloured noise biases least squares, and extended least squares far less") {
    std::vector<double> plain_errors, extended_errors;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        RecursiveLeastSquares plain(1, 0.999), extended(1, 0.999, RecursiveLeastSquares::NoiseTerms::two);
        for (const Sample& sample : record(1, seed, {0.8, 0}, 6000)) {
            plain.push(sample);
            extended.push(sample);
        }
        plain_errors.push_back(distance_from_truth(plain.plant().pole()));
        extended_errors.push_back(distance_from_truth(extended.plant().pole()));
    }
    CHECK(mean(extended_errors) < 0.5 * mean(plain_errors));
}
