#include "gaprocs/traditional.hpp"
#include "gaprocs/usual_settings.hpp"
#include "problems/benchmark/benchmark.hpp"
#include "problems/benchmark/tours.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the length of the shortest tour from city 0.
double shortest_of_all(const Tour& tour) {
    std::vector<std::size_t> order(tour.representation().places());
    std::iota(order.begin(), order.end(), std::size_t{0});
    double shortest = std::numeric_limits<double>::infinity();
    do
        shortest = std::min(shortest, tour.objective(order));
    while (std::next_permutation(order.begin() + 1, order.end()));
    return shortest;
}

LatticeTour lattice(std::size_t rows, std::size_t columns) { return {.rows = rows, .columns = columns}; }

} // namespace

TEST_CASE("the known shortest tours around a circle and on a lattice are the shortest of all tours") {
    for (std::size_t cities : {1u, 2u, 3u, 4u, 7u}) {
        Tour tour = CircleTour{.cities = cities}.problem();
        CHECK(tour.optimum().value() == doctest::Approx(shortest_of_all(tour)));
    }
    for (auto [rows, columns] : {std::pair{1u, 1u}, {1u, 5u}, {2u, 2u}, {2u, 4u}, {4u, 2u}, {3u, 3u}}) {
        Tour tour = lattice(rows, columns).problem();
        CHECK(tour.optimum().value() == doctest::Approx(shortest_of_all(tour)));
    }
    CHECK(lattice(5, 4).problem().optimum() == 20);
    CHECK(lattice(5, 5).problem().optimum().value() == doctest::Approx(24 + std::sqrt(2)));
}

TEST_CASE("random cities depend on the seed, and their shortest tour is unknown") {
    Tour one = RandomTour{.cities = 8, .seed = 1}.problem(), other = RandomTour{.cities = 8, .seed = 2}.problem();
    std::vector<std::size_t> order{0, 1, 2, 3, 4, 5, 6, 7};
    CHECK(one.objective(order) == RandomTour{.cities = 8, .seed = 1}.problem().objective(order));
    CHECK(one.objective(order) != other.objective(order));
    CHECK_FALSE(one.optimum());
}

TEST_CASE(
    "a search finds the shortest of all 2520 tours of eight random cities, and the shortest tour around a circle") {
    auto search = [](const Tour& tour, std::size_t generations) {
        auto problem = minimise(tour);
        SearchSettings settings = usual_settings(*problem);
        settings.elite = 1;
        settings.mutation_probability = 0.05;
        return -run_traditional(*problem, generations, settings, RandomStream(1, "tour")).best().best.fitness;
    };
    Tour eight = RandomTour{.cities = 8, .seed = 3}.problem();
    CHECK(search(eight, 100) == doctest::Approx(shortest_of_all(eight)));
    Tour circle = CircleTour{.cities = 10}.problem();
    CHECK(search(circle, 300) == doctest::Approx(*circle.optimum()));
}

TEST_CASE("every benchmark problem can be made by name, with default parameters and a representation") {
    ProblemRegistry problems;
    add_benchmark_problems(problems);
    CHECK(problems.names().size() == 26);
    for (const std::string& name : problems.names()) {
        CAPTURE(name);
        auto problem = problems.find(name).problem();
        CHECK(problem->objective());
        RandomStream random(1, name);
        Genome genome = problem->representation().random(random);
        CHECK(genome.size() == problem->bits());
        CHECK(problem->decode(genome).size() == problem->parameter_names().size());
    }
    CHECK(problems.find("rastrigin(dimensions=20, bits=16)").problem()->bits() == 320);
    CHECK(problems.find("one-max(4096)").problem()->bits() == 4096);
}
