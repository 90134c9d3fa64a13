#include "gaprocs/objective_problem.hpp"
#include "problems/benchmark/functions.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the function's value at the point where every parameter is `each`.
template <class Function>
double at(const Function& function, double each) {
    return function.objective(std::vector<double>(function.representation().parameters(), each));
}

/// Returns the least value of all strings. REQUIRES: at most 16 bits.
template <class Function>
double least_of_all(const Function& function) {
    auto problem = minimise(function);
    REQUIRE(problem->bits() <= 16);
    double least = std::numeric_limits<double>::infinity();
    for (std::uint64_t code = 0; code < std::uint64_t{1} << problem->bits(); ++code) {
        Genome genome(problem->bits());
        genome.set_field(0, problem->bits(), code);
        least = std::min(least, -problem->fitness(genome, {}, 1));
    }
    return least;
}

template <class Function>
Function small(std::size_t bits) {
    Function function;
    function.dimensions = 2;
    function.bits = bits;
    return function;
}

/// Checks that no random point is below the stated optimum.
template <class Function>
void check_optimum(const Function& function) {
    auto problem = minimise(function)->coded(Coding::real);
    Representation reals = problem->representation();
    RandomStream random(1, Function::name);
    for (int i = 0; i < 20000; ++i)
        REQUIRE(-problem->fitness(reals.random(random), {}, 1) >= problem->objective()->optimum.value() - 1e-9);
}

} // namespace

TEST_CASE("each function has its published optimum") {
    CHECK(at(Sphere{}, 0) == 0);
    CHECK(at(Rosenbrock{}, 1) == 0);
    CHECK(at(Rastrigin{}, 0) == 0);
    CHECK(at(Griewank{}, 0) == 0);
    CHECK(std::abs(at(Ackley{}, 0)) < 1e-14);
    CHECK(at(Ackley{}, 1) == doctest::Approx(20 - 20 * std::exp(-0.2)));
    CHECK(std::abs(at(Schwefel{}, Schwefel::best_place)) < 1e-9);
    CHECK(at(StepFunction{}, -5.12) == -30);
    CHECK(StepFunction{}.optimum() == -30);
    Quartic quiet;
    quiet.noise = 0;
    CHECK(at(quiet, 0) == quiet.optimum());
    CHECK(std::abs(at(Foxholes{}, -32) - Foxholes{}.optimum()) < 1e-6);
}

TEST_CASE("no random point is better than the optimum") {
    check_optimum(Sphere{});
    check_optimum(Rosenbrock{});
    check_optimum(Rastrigin{});
    check_optimum(Griewank{});
    check_optimum(Ackley{});
    check_optimum(Schwefel{});
    check_optimum(StepFunction{});
    check_optimum(Foxholes{});
}

TEST_CASE("no string is better than the optimum") {
    CHECK(least_of_all(small<Sphere>(8)) == 0);
    CHECK(least_of_all(small<Rastrigin>(8)) == 0);
    CHECK(least_of_all(small<Griewank>(8)) == 0);
    CHECK(least_of_all(small<StepFunction>(8)) == -12);
    double schwefel = least_of_all(small<Schwefel>(8)); // no code is exactly at the optimum: the nearest is 0.97 away
    CHECK(schwefel > 0);
    CHECK(schwefel < 2 * 0.2);
    CHECK(std::abs(least_of_all(Foxholes{.bits = 8}) - 0.998004) < 0.01);
}

TEST_CASE("values away from the optimum agree with a hand computation") {
    CHECK(at(Sphere{}, 2) == 12);
    CHECK(at(Rosenbrock{}, 0) == 1);
    CHECK(Rosenbrock{}.objective(std::vector<double>{-1, 2}) == 104);
    CHECK(at(small<Rastrigin>(8), 0.5) == doctest::Approx(2 * 20.25));
    CHECK(at(small<Rastrigin>(8), 1) == doctest::Approx(2));
    CHECK(StepFunction{}.objective(std::vector<double>{0.5, -0.5, 2, -3.7, 0}) == -3);
    Quartic quiet = small<Quartic>(8);
    quiet.noise = 0;
    CHECK(at(quiet, 2) == 48);
    CHECK(at(Foxholes{}, 50) == doctest::Approx(500).epsilon(1e-3));    // the plain
    CHECK(at(Foxholes{}, 16) == doctest::Approx(18.304).epsilon(1e-3)); // hole 19
}

TEST_CASE("the noise of the quartic is normal, and equal for equal strings") {
    Quartic noisy = small<Quartic>(8), quiet = noisy, other = noisy;
    quiet.noise = 0;
    other.seed = 2;
    CHECK_FALSE(noisy.optimum());
    RandomStream random(1, "quartic");
    double sum = 0, squares = 0;
    int different = 0;
    for (int i = 0; i < 10000; ++i) {
        std::vector<double> x{random.uniform(), random.uniform()};
        double noise = noisy.objective(x) - quiet.objective(x);
        CHECK(noisy.objective(x) == noisy.objective(x));
        different += noisy.objective(x) != other.objective(x);
        sum += noise;
        squares += noise * noise;
    }
    CHECK(different == 10000);
    CHECK(std::abs(sum / 10000) < 0.05);
    CHECK(std::abs(squares / 10000 - 1) < 0.08);
}

TEST_CASE("a costly function is Rastrigin's, however often it is computed") {
    RandomStream random(1, "points");
    for (int i = 0; i < 100; ++i) {
        const std::vector<double> x{10 * random.uniform() - 5, 10 * random.uniform() - 5};
        for (const std::size_t work : {1, 2, 1000}) {
            Costly costly;
            costly.work = work;
            CHECK(costly.objective(x) == Rastrigin{}.objective(x));
        }
    }
}
