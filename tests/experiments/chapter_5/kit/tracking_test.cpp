#include "experiments/chapter_5/kit/tracking.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the true pole, delayed by `late` generations.
std::vector<Pole> late_by(double late, const PlantChange& change) {
    std::vector<Pole> found;
    for (int generation = 0; generation <= 600; ++generation)
        found.push_back(pole_of(a1_at(change, generation - late), Plant{}.a2));
    return found;
}

double figure(const std::vector<Pole>& found, const PlantChange& change, Tracking which) {
    return track(found, change)[static_cast<std::size_t>(which)];
}

} // namespace

TEST_CASE("the true pole has a delay of 40 and 126 generations on the ramp, no lag and no error") {
    auto found = late_by(0, PlantChange::ramp);
    CHECK(figure(found, PlantChange::ramp, Tracking::delay_20) == 40);
    CHECK(figure(found, PlantChange::ramp, Tracking::delay_63) == 126);
    CHECK(figure(found, PlantChange::ramp, Tracking::lag) == 0);
    for (auto error : {Tracking::error_before, Tracking::error_during, Tracking::error_after,
                       Tracking::deviation_before, Tracking::deviation_after})
        CHECK(figure(found, PlantChange::ramp, error) == 0);
}

TEST_CASE("the lag of a delayed true pole is its delay, for a ramp and for a step") {
    for (auto change : {PlantChange::ramp, PlantChange::step}) {
        auto found = late_by(70, change);
        CHECK(figure(found, change, Tracking::lag) == 70);
        CHECK(figure(found, change, Tracking::error_during) > 0);
    }
    CHECK(figure(late_by(70, PlantChange::ramp), PlantChange::ramp, Tracking::delay_20) == 110);
}

TEST_CASE("a pole that is never found has the greatest delay, and its distance as its error") {
    std::vector<Pole> stuck(601, pole_of(1.5, Plant{}.a2));
    CHECK(figure(stuck, PlantChange::ramp, Tracking::delay_20) == 400);
    Pole before = stuck.front(), after = pole_of(0.5, Plant{}.a2);
    CHECK(figure(stuck, PlantChange::ramp, Tracking::error_after) ==
          doctest::Approx(std::hypot(before.alpha - after.alpha, before.beta - after.beta)));
}

TEST_CASE("one outlier in eleven causes no delay; the deviation is taken over time") {
    auto found = late_by(0, PlantChange::none);
    found[250].alpha = 0.25;
    CHECK(figure(found, PlantChange::ramp, Tracking::delay_20) == 400);
    for (std::size_t generation = 500; generation < 600; generation += 2)
        found[generation].alpha = 0.65;
    CHECK(figure(found, PlantChange::none, Tracking::deviation_after) == test::nearly(0.05 * std::sqrt(100.0 / 99)));
}
