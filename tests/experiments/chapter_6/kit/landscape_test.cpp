#include "experiments/chapter_6/kit/landscape.hpp"
#include "experiments/chapter_6/kit/plant_runs.hpp"
#include "gaprocs/traditional.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("the moments of the window give the same squared error as the samples") {
    const SearchProblem& problem = plant_search_problem();
    RandomStream random(4, "strings");
    std::vector<Sample> window = plant_record({}, RandomStream(4, "plant"));
    window.resize(30);
    WindowMoments moments(window);
    for (const Genome& genome : random_population(200, problem.bits(), random)) {
        double squares = 0;
        for (const Sample& sample : window) {
            double error = problem.error(genome, sample);
            squares += error * error;
        }
        CHECK(moments.squared_error(genome) == doctest::Approx(squares).epsilon(1e-6));
    }
}

TEST_CASE("the landscape of the shortest strings agrees with an independent computation") {
    Recoding reading = plant_reading(1); // seven bits
    LandscapeFacts facts = enumerate_landscape(reading, 4);
    const SearchProblem& problem = plant_search_problem();
    std::vector<Sample> window = plant_record({}, RandomStream(4, "plant"));
    window.resize(30);
    std::vector<Genome> all;
    for (std::size_t i = 0; i < 128; ++i) {
        all.emplace_back(7);
        all.back().set_field(0, 7, i);
    }
    auto fitness = evaluate(problem, reading.to_problem(all), window, 10);
    double positive = 0;
    std::size_t minima = 0;
    for (std::size_t i = 0; i < 128; ++i) {
        positive += fitness[i] > 0;
        bool better = false;
        for (std::size_t bit = 1; bit < 128; bit <<= 1)
            better |= fitness[i ^ bit] > fitness[i] + 0.01;
        minima += !better;
    }
    CHECK(facts.fit_percent == doctest::Approx(100 * positive / 128));
    CHECK(facts.minima <= minima);
    CHECK(facts.minima >= 1);
    CHECK(facts.optimum_percent > 0);
    CHECK(facts.optimum_percent <= 100);
}

TEST_CASE("a search of the plant is reproducible, and with good settings it converges") {
    PlantSearch search{plant_settings(100), plant_reading(7, Coding::gray)};
    PlantOutcome first = run_plant_search(search, 11), again = run_plant_search(search, 11);
    CHECK(first.pole_error == again.pole_error);
    CHECK(first.converged());
    CHECK(first.followed());
    CHECK(first.converged_at < 100);
}
