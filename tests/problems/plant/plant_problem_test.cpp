#include "problems/plant/plant_problem.hpp"

#include "gaprocs/search_problem.hpp"
#include "gaprocs/traditional.hpp"
#include "runtime/random.hpp"
#include "tests/nearly.hpp"
#include "tests/runtime/each_vector_width.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

using namespace placedpar;

namespace {

std::vector<Sample> unchanging(double noise = 0) {
    return plant_record({.change = PlantChange::none, .noise = noise}, RandomStream(1, "plant"));
}

/// Makes a string from the codes of d, alpha, beta, gamma, delta, b0.
Genome string_of(std::array<std::uint64_t, 6> codes) {
    Genome genome(37);
    std::size_t first = 0;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        std::size_t bits = i == 0 ? 2 : 7;
        genome.set_field(first, bits, codes[i]);
        first += bits;
    }
    return genome;
}

} // namespace

TEST_CASE("the plant's string has the 37 bits and resolutions of Table 5.1") {
    PlantProblem problem;
    CHECK(problem.bits() == 37);
    CHECK(problem.decode(string_of({0, 0, 64, 112, 48, 127})) ==
          std::vector<double>{1, -1, 0, .75, -.25, 2 - 2. / 128});
    CHECK(problem.decode(string_of({3, 127, 65, 0, 0, 1})) ==
          std::vector<double>{4, 1 - 1. / 64, 1. / 64, -1, -1, 1. / 64});
}

TEST_CASE("numbers up to the upper bound give one of the four delays") {
    const ParameterField delay = PlantProblem().coding().field(0);
    CHECK(delay.rounded(5) == 4);
    CHECK(delay.rounded(3.9) == 3);
}

TEST_CASE("the plant of 5.8 is on the grid except for beta, and its error is 0") {
    PlantProblem problem;
    std::vector<double> truth = parameters_of(Plant{});
    CHECK(truth[1] == .75);
    CHECK(truth[2] == doctest::Approx(std::sqrt(.7 - .5625)));
    CHECK(truth[3] == -.25);
    CHECK(truth[4] == -.25);
    auto weights = PoleZeroPlant{truth[0], truth[1], truth[2], truth[3], truth[4], truth[5]}.weights();
    for (const Sample& sample : unchanging())
        CHECK(problem.error_of<double>(weights, sample) == doctest::Approx(0).epsilon(1e-12));
    // The nearest beta is .375, so the weight of y(k-2) is .0031 too large.
    Genome nearest = string_of({0, 112, 88, 48, 48, 64});
    for (const Sample& sample : unchanging())
        CHECK(problem.error(nearest, sample) == doctest::Approx((.5625 + .140625 - .7) * sample[2]));
}

TEST_CASE("a negative delta is a real pair of zeros, a positive one a complex pair") {
    for (double delta : {-.5, .5}) {
        std::complex<double> root(0.25, delta > 0 ? delta : 0);
        std::complex<double> first = delta > 0 ? root : root + std::abs(delta);
        std::complex<double> second = delta > 0 ? std::conj(root) : root - std::abs(delta);
        auto weights = PoleZeroPlant{2, 0, 0, 0.25, delta, 1.5}.weights();
        CHECK(weights[3] == 1.5);
        CHECK(weights[4] == doctest::Approx(-1.5 * (first + second).real()));
        CHECK(weights[5] == doctest::Approx(1.5 * (first * second).real()));
        CHECK(weights[2] == 0);
        CHECK(weights[6] == 0);
    }
}

TEST_CASE("plants computed together have the fitness of separate plants, in both codings") {
    auto record = unchanging(0.3);
    auto window = std::span<const Sample>(record).last(30);
    RandomStream random(3, "population");
    auto population = random_population(37, 37, random);
    for (Coding coding : {Coding::natural, Coding::gray}) {
        auto problem = make_search_problem(PlantProblem(), coding);
        auto together = evaluate(*problem, population, window, 10);
        for (std::size_t i = 0; i < population.size(); ++i)
            CHECK(together[i] == problem->fitness(population[i], window, 10));
    }
}

TEST_CASE("a simulated plant continues from its own outputs") {
    SimulatedPlantProblem problem;
    auto record = unchanging(0.3);
    auto window = std::span<const Sample>(record).last(10);
    Genome genome = string_of({1, 100, 80, 30, 90, 70});
    PoleZeroPlant plant = problem.plant(genome);
    double last = window[0][1], before = window[0][2];
    std::vector<double> expected;
    for (const Sample& sample : window) {
        double forced = plant.b0 * (sample[4] - 2 * plant.gamma * sample[5] +
                                    (plant.gamma * plant.gamma + plant.delta * plant.delta) * sample[6]);
        double output =
            2 * plant.alpha * last - (plant.alpha * plant.alpha + plant.beta * plant.beta) * before + forced;
        before = last, last = output;
        expected.push_back(sample[0] - output);
    }
    auto errors = make_search_problem(problem)->errors(genome, window);
    REQUIRE(errors.size() == expected.size());
    for (std::size_t i = 0; i < errors.size(); ++i)
        CHECK(errors[i] == doctest::Approx(expected[i]));
    CHECK(errors[0] == make_search_problem(PlantProblem())->errors(genome, window)[0]); // from measured outputs
    CHECK(errors[1] != make_search_problem(PlantProblem())->errors(genome, window)[1]);
}

TEST_CASE("the true simulated plant has the noise as its error") {
    std::vector<double> truth = parameters_of(Plant{});
    const auto weights = PoleZeroPlant{truth[0], truth[1], truth[2], truth[3], truth[4], truth[5]}.weights();
    auto error = SimulatedPlantProblem().errors_along<double>(weights);
    for (const Sample& sample : unchanging())
        CHECK(error(sample) == doctest::Approx(0).epsilon(1e-9));
}

TEST_CASE("simulated plants computed together have the fitness of separate plants, in both codings") {
    auto record = unchanging(0.3);
    auto window = std::span<const Sample>(record).last(30);
    RandomStream random(4, "population");
    auto population = random_population(37, 37, random);
    for (Coding coding : {Coding::natural, Coding::gray, Coding::named("natural(2)")}) {
        auto problem = make_search_problem(SimulatedPlantProblem(), coding);
        CHECK(problem->depends_on_window());
        auto strings = random_population(37, problem->bits(), random);
        std::vector<double> together(strings.size());
        test::in_each_vector_width([&] {
            problem->fitness_of(strings, window, 100, together);
            for (std::size_t i = 0; i < strings.size(); ++i) {
                double sum = 0;
                for (double error : problem->errors(strings[i], window))
                    sum += fitness_term(100, error);
                CHECK(together[i] == problem->fitness(strings[i], window, 100));
                CHECK(together[i] == sum);
            }
        });
    }
}

TEST_CASE("a traditional algorithm finds the plant") {
    SearchSettings settings;
    settings.population = 100;
    settings.elite = 1;
    settings.reproduction = UniversalReproduction{};
    settings.window = {.length = 30, .first = 30, .trials = 3, .bias = 10};
    auto record = unchanging();
    auto short_record = std::span<const Sample>(record).first(70);
    auto result = run_traditional(*make_search_problem(PlantProblem()), short_record, settings, RandomStream(1, "ga"));
    const auto& found = result.estimates.back().parameters;
    CHECK(found[0] == 1);
    CHECK(found[1] == test::nearly(.75, .05));
    CHECK(std::abs(found[2]) == test::nearly(.371, .1));
}
