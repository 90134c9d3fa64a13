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

TEST_CASE("the don't-care bits change the fitness as the problem itself computes it") {
    const std::vector<double> found = fitness_by_low_bits(0, 4);
    const SearchProblem& problem = plant_search_problem();
    std::vector<Sample> window = plant_record({}, RandomStream(4, "plant"));
    window.resize(30);
    auto fitness = [&](std::size_t number) {
        Genome string(37); // d = 1, and alpha .75, beta .375, gamma -.25, delta -.25, b0 1, plus the number's digits
        std::size_t first = 2;
        for (std::uint64_t code : {112u, 88u, 48u, 48u, 64u}) {
            string.set_field(first, 7, code + number % 8);
            number /= 8;
            first += 7;
        }
        double sum = 0;
        for (const Sample& sample : window)
            sum += 10 - problem.error(string, sample) * problem.error(string, sample);
        return sum;
    };
    REQUIRE(found.size() == 32768);
    for (std::size_t i = 0; i < found.size(); i += 97)
        CHECK(found[i] == doctest::Approx(fitness(i)));
}
