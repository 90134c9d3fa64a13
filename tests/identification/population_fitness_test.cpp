// Tests that a whole population's fitness equals that of each individual evaluated alone, to the bit.

#include "gaprocs/fitness.hpp"
#include "gaprocs/population_fitness.hpp"
#include "gaprocs/processes/share.hpp"
#include "gaprocs/representation/genome.hpp"
#include "gaprocs/search_problem.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "identification/circuit_problem.hpp"
#include "runtime/random.hpp"
#include "tests/runtime/each_vector_width.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::uint64_t bits_of(double value) { return std::bit_cast<std::uint64_t>(value); }

/// Returns a sample with values that a record may have, and some that it should not.
Sample random_sample(std::size_t links, RandomStream& random) {
    auto draw = [&](double low, double high) { return low + (high - low) * random.uniform(); };
    Sample sample;
    for (std::size_t link = 0; link < links; ++link)
        sample.insert(sample.end(),
                      {draw(0, 3000), draw(-3000, 3000), draw(-100, 150), draw(0.001, 0.5), draw(0, 0.5)});
    if (random.below(10) == 0)
        sample[random.below(static_cast<std::uint32_t>(sample.size()))] = random.below(2) ? not_a_number : infinity;
    return sample;
}

void check_population(const SearchProblem& problem, std::size_t links, std::size_t individuals, RandomStream& random) {
    auto population = random_population(individuals, problem.bits(), random);
    std::vector<Sample> window;
    for (std::size_t i = random.below(11); i > 0; --i)
        window.push_back(random_sample(links, random));
    std::vector<double> fitness(individuals, not_a_number);
    problem.fitness_of(population, window, 400, fitness);
    test::in_each_vector_width([&] {
        std::vector<double> again(individuals, not_a_number);
        problem.fitness_of(population, window, 400, again);
        REQUIRE(again == fitness);
    });
    for (std::size_t i = 0; i < individuals; ++i) {
        REQUIRE(bits_of(fitness[i]) == bits_of(problem.fitness(population[i], window, 400)));
        double sum = 0;
        for (const Sample& sample : window)
            sum += fitness_term(400, problem.error(population[i], sample));
        REQUIRE(fitness[i] == sum);
    }
}

} // namespace

TEST_CASE("terms of eight errors computed together equal separate terms") {
    RandomStream random(1, "terms");
    const std::array<double, 10> special{0, -0.0, 20, infinity, -infinity, not_a_number, 1e300, 1e-300, 2896.3, 2896.4};
    for (int i = 0; i < 10'000; ++i) {
        std::array<double, 8> errors{};
        for (double& error : errors)
            error = random.below(3) ? (random.uniform() - 0.5) * 6000 : special.at(random.below(10));
        double bias = random.below(2) ? 400 : 1e7 * random.uniform(); // the upper limit is 2^23
        auto terms = fitness_term<Lanes<2>>(bias, errors).numbers();
        for (std::size_t lane = 0; lane < errors.size(); ++lane)
            REQUIRE(bits_of(terms[lane]) == bits_of(fitness_term(bias, errors[lane])));
    }
}

TEST_CASE("CircuitProblem can compute the errors of whole populations") {
    CHECK(ErrorOfParameters<CircuitProblem, Genome>);
    CHECK(ErrorOfParameters<CircuitProblem, GrayCoded<Genome>>);
}

TEST_CASE(
    "random populations of the boom have the fitness of single strings, for every size, window, length and coding") {
    RandomStream random(2, "boom");
    for (std::size_t bits : {1u, 10u, 12u, 40u})
        for (Coding coding : {Coding::natural, Coding::gray}) {
            auto problem = make_search_problem(CircuitProblem(boom_circuit(), fitted_flow_constants(), bits), coding);
            for (std::size_t individuals = 0; individuals < 34; ++individuals)
                for (int i = 0; i < 10; ++i)
                    check_population(*problem, 1, individuals, random);
        }
}

TEST_CASE("random populations of one to four links have the fitness of single strings") {
    RandomStream random(3, "circuits");
    for (Configuration configuration : all_configurations)
        for (LinkSet group : coupled_groups(configuration)) {
            Circuit circuit = circuit_of(configuration, group);
            for (std::size_t bits : {10u, 20u})
                for (Coding coding : {Coding::natural, Coding::gray}) {
                    auto problem = make_search_problem(CircuitProblem(circuit, rounded_flow_constants(), bits), coding);
                    for (std::size_t individuals : {1u, 7u, 8u, 9u, 120u})
                        check_population(*problem, circuit.size(), individuals, random);
                }
        }
}

TEST_CASE("the fitness of a population is the same if several evaluators compute shares of it") {
    auto problem = make_search_problem(CircuitProblem(boom_circuit(), rounded_flow_constants()));
    RandomStream random(4, "shares");
    auto population = random_population(30, problem->bits(), random);
    std::vector<Sample> window;
    for (int i = 0; i < 10; ++i)
        window.push_back(random_sample(1, random));
    std::vector<double> whole(30), pieces(30);
    problem->fitness_of(population, window, 400, whole);
    for (std::size_t evaluators : {1u, 2u, 7u, 30u})
        for (Split split : {Split::individuals, Split::evaluations}) {
            std::fill(pieces.begin(), pieces.end(), 0.0);
            for (const Share& share : deal(30, 10, evaluators - 1, split)) {
                auto strings = std::span(population).subspan(share.first_individual(), share.individuals());
                add_terms(share, evaluate_share(*problem, share, strings, window, 400), pieces);
            }
            CHECK(pieces == whole);
        }
}
