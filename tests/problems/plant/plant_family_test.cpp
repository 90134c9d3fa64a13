#include "gaprocs/problem_registry.hpp"
#include "problems/plant/plant_family.hpp"
#include "problems/plant/plant_record.hpp"
#include "runtime/random.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

const RecordedProblem& plant_named(const std::string& name) {
    static const ProblemRegistry problems = [] {
        ProblemRegistry registry;
        registry.add(plant_family(7));
        return registry;
    }();
    return problems.find(name);
}

std::vector<Sample> record_of_family(const PlantExperiment& experiment) {
    return plant_record(experiment, RandomStream(7, "record of the plant"));
}

} // namespace

TEST_CASE("noise, its colour, the change and the length of the record are given by name") {
    CHECK(plant_named("plant").record() == record_of_family({}));
    CHECK(plant_named("plant(noise = 0.3)").record() == record_of_family({.noise = 0.3}));
    CHECK(plant_named("plant(noise = 0.3, c1 = 0.5, c2 = 0.25)").record() ==
          record_of_family({.noise = 0.3, .colour = {0.5, 0.25}}));
    CHECK(plant_named("plant(lasts = 0)").record() == record_of_family({.change = PlantChange::step}));
    CHECK(plant_named("plant(a1 = 1.5)").record() == record_of_family({.change = PlantChange::none}));
    CHECK(plant_named("plant(from = 30, generations = 61, per_sample = 1)").record() ==
          record_of_family({.change = {.from = 30}, .generations = 61, .per_sample = 1}));
    CHECK(plant_named("plant(noise = 0.3)").record() != plant_named("plant").record());
}

TEST_CASE("the plant's error is of a prediction or of a simulation") {
    CHECK_FALSE(plant_named("plant(simulated = 0)").problem()->depends_on_window());
    CHECK(plant_named("plant(simulated = 1)").problem()->depends_on_window());
    CHECK(plant_named("plant(simulated = 1)").record() == plant_named("plant").record());
}

TEST_CASE("the true parameters are the parameters at the record's end") {
    CHECK(plant_named("plant").problem()->true_parameters()[1] == 0.25);
    CHECK(plant_named("plant(a1 = 1.5)").problem()->true_parameters()[1] == 0.75);
    CHECK(plant_named("plant(generations = 300)").problem()->true_parameters()[1] == 0.5);
}

TEST_CASE("impossible numbers of a plant are refused") {
    CHECK_THROWS_WITH_AS(plant_named("plant(a1 = 2)"), "a1 = 2 is out of range: a1 is a number from -1.67 to 1.67",
                         UserError);
    CHECK_THROWS_WITH_AS(plant_named("plant(noise = -1)"),
                         "noise = -1 is out of range: noise is a number from 0 to 1000", UserError);
    CHECK_THROWS_WITH_AS(plant_named("plant(generations = 0)"),
                         "generations = 0 is out of range: generations is a whole number from 1 to 1000000", UserError);
}
