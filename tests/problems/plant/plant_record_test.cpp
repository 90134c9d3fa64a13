#include "problems/plant/plant_record.hpp"

#include "runtime/random.hpp"
#include "tests/nearly.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

using namespace placedpar;

namespace {

std::vector<std::vector<double>> record_of(const PlantExperiment& experiment, std::uint64_t seed = 1) {
    return plant_record(experiment, RandomStream(seed, "plant"));
}

/// Returns y(k) minus the value by equation 5.8.
double rest(const std::vector<double>& sample, double a1) {
    return sample[0] - (a1 * sample[1] - 0.7 * sample[2] + sample[3] + 0.5 * sample[4]);
}

double root_mean_square(const std::vector<double>& values) {
    double sum = 0;
    for (double each : values)
        sum += each * each;
    return std::sqrt(sum / static_cast<double>(values.size()));
}

} // namespace

TEST_CASE("a change of a1 from 1.5 to .5 moves the pole along a circle of modulus .837") {
    for (auto change : {PlantChange::ramp, PlantChange::step}) {
        CHECK(a1_at(change, 0) == 1.5);
        CHECK(a1_at(change, 199) == 1.5);
        CHECK(a1_at(change, 400) == 0.5);
        CHECK(a1_at(change, 600) == 0.5);
    }
    CHECK(a1_at(PlantChange::none, 600) == 1.5);
    CHECK(a1_at(PlantChange::ramp, 300) == 1.0);
    CHECK(a1_at(PlantChange::step, 200) == 0.5);
    Pole before = pole_of(1.5, -0.7), after = pole_of(0.5, -0.7);
    CHECK(before.alpha == 0.75);
    CHECK(before.beta == doctest::Approx(0.371).epsilon(0.001));
    CHECK(after.alpha == 0.25);
    CHECK(after.beta == doctest::Approx(0.798).epsilon(0.001));
    CHECK(std::hypot(after.alpha, after.beta) == doctest::Approx(std::sqrt(0.7)));
}

TEST_CASE("the record follows 5.8 and begins with a full window; each sample holds earlier outputs and inputs") {
    PlantExperiment experiment;
    auto record = record_of(experiment);
    CHECK(record.size() == 29 + 201);
    for (std::size_t i = 0; i < record.size(); ++i) {
        double generation = i < 29 ? 0 : static_cast<double>(3 * (i - 29));
        CHECK(rest(record[i], a1_at(experiment.change, generation)) == doctest::Approx(0).epsilon(1e-12));
        if (i == 0)
            continue;
        CHECK(record[i][1] == record[i - 1][0]);
        CHECK(record[i][2] == record[i - 1][1]);
        for (std::size_t delay = 2; delay <= plant_inputs; ++delay)
            CHECK(record[i][2 + delay] == record[i - 1][1 + delay]);
        CHECK(std::abs(record[i][3]) == 1);
    }
}

TEST_CASE("the change of a1 removes most of the signal's energy") {
    PlantExperiment experiment{.generations = 1501};
    auto record = record_of(experiment);
    std::vector<double> before, after;
    for (std::size_t i = 0; i < record.size(); ++i)
        if (i < 29 + 66)
            before.push_back(record[i][0]);
        else if (i >= 29 + 150)
            after.push_back(record[i][0]);
    CHECK(root_mean_square(before) == doctest::Approx(7.7).epsilon(0.25));
    CHECK(root_mean_square(after) == doctest::Approx(1.63).epsilon(0.15));
}

TEST_CASE("noise has its standard deviation and its colour") {
    PlantExperiment experiment{.change = PlantChange::none, .noise = 0.3, .generations = 30000};
    auto deviation_with = [&](std::array<double, 2> colour) {
        experiment.colour = colour;
        std::vector<double> rests;
        for (const auto& sample : record_of(experiment))
            rests.push_back(rest(sample, 1.5));
        double correlation = 0;
        for (std::size_t i = 1; i < rests.size(); ++i)
            correlation += rests[i] * rests[i - 1] / static_cast<double>(rests.size());
        return std::pair(root_mean_square(rests), correlation);
    };
    auto [white, none] = deviation_with({0, 0});
    CHECK(white == test::nearly(0.3, 0.03));
    CHECK(std::abs(none) < 0.003);
    auto [coloured, some] = deviation_with({-1, 0.2});
    CHECK(coloured == test::nearly(0.3 * std::sqrt(1 + 1 + 0.04), 0.03));
    CHECK(some == test::nearly(0.09 * (-1 - 0.2), 0.05));
}

TEST_CASE("a record depends only on its random stream, and its input may begin anywhere in the period") {
    CHECK(record_of({}, 7) == record_of({}, 7));
    CHECK(record_of({}, 7) != record_of({}, 8));
}

TEST_CASE("impossible experiments are refused") {
    CHECK_THROWS_WITH_AS(record_of({.window = 0}),
                         "the plant's record begins with a window of 0 samples, expected at least 1", UserError);
    CHECK_THROWS_WITH_AS(record_of({.per_sample = 0}), "the number of generations per sample is 0, expected at least 1",
                         UserError);
    CHECK_THROWS_WITH_AS(record_of({.noise = -1}), "the plant's noise is -1, expected 0 or a positive number",
                         UserError);
    CHECK_THROWS_AS(record_of({.noise = std::nan("")}), UserError);
}
