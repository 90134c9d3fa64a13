// Tests how well a search follows the plant's pole, and the reading of the plant's string.

#include "experiments/chapter_6/kit/plant_runs.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numeric>

using namespace placedpar;

namespace {

/// Returns the outcome of answers whose alpha is wrong by distance(generation) in each generation of Table 5.4.
/// `beta_sign` selects one of the two conjugate poles.
PlantOutcome outcome_off_by(const std::function<double(int)>& distance, double beta_sign = 1) {
    PoleTrack track;
    for (int generation = 0; generation <= 600; ++generation) {
        const Pole pole = pole_of(a1_at(PlantChange::ramp, generation), Plant().a2);
        track.add({1, pole.alpha + distance(generation), beta_sign * pole.beta});
    }
    return track.outcome();
}

/// Returns a distance that is large except in these generations.
std::function<double(int)> near_within(int first, int end) {
    return [=](int generation) { return generation >= first && generation < end ? 0.05 : 0.5; };
}

} // namespace

TEST_CASE("the error is the root of the mean square over each of the three stretches") {
    const PlantOutcome outcome = outcome_off_by([](int generation) {
        return generation < 200 ? (generation % 2 == 0 ? 0.03 : 0.04) : generation < 400 ? 0.2 : -0.3;
    });
    CHECK(outcome.pole_error[0] == doctest::Approx(std::sqrt((0.0009 + 0.0016) / 2)));
    CHECK(outcome.pole_error[1] == doctest::Approx(0.2));
    CHECK(outcome.pole_error[2] == doctest::Approx(0.3));
    CHECK(outcome.converged());
    CHECK_FALSE(outcome.followed());
}

TEST_CASE("a string may represent either of the two conjugate poles") {
    const PlantOutcome outcome = outcome_off_by([](int) { return 0; }, -1);
    for (double error : outcome.pole_error)
        CHECK(error == doctest::Approx(0));
    CHECK(outcome.converged_at == 0);
    CHECK(outcome.followed());
}

TEST_CASE("a search has converged at the first of ten generations in a row near the pole") {
    CHECK(outcome_off_by(near_within(50, 601)).converged_at == 50);
    CHECK(outcome_off_by(near_within(20, 30)).converged_at == 20);
    CHECK(outcome_off_by(near_within(20, 29)).converged_at == 200); // nine generations are too few
    const auto interrupted = [](int generation) {
        return generation >= 20 && generation < 40 && generation != 29 ? 0.05 : 0.5;
    };
    CHECK(outcome_off_by(interrupted).converged_at == 30);
    CHECK(outcome_off_by(near_within(190, 601)).converged_at == 190);
    CHECK(outcome_off_by(near_within(191, 601)).converged_at == 200); // the plant has begun to change
}

TEST_CASE("the plant's string has the 37 bits of Table 5.1, and the coarse string its stated bits of each number") {
    const auto fields = plant_field_bits();
    CHECK(std::accumulate(fields.begin(), fields.end(), std::size_t{0}) == 37);
    CHECK(plant_search_problem().bits() == 37);
    CHECK(plant_reading(7).length() == 37);
    for (std::size_t bits : {1U, 3U, 6U})
        CHECK(plant_reading(bits).length() == 2 + 5 * bits);
}
