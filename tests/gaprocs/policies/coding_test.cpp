#include "gaprocs/objective_problem.hpp"
#include "gaprocs/policies/coding.hpp"
#include "gaprocs/representation/coding.hpp"
#include "runtime/random.hpp"
#include "tests/gaprocs/line_problem.hpp"
#include "tests/gaprocs/objectives.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("codings are named by their text") {
    for (const char* text : {"natural", "gray", "real", "natural(dont_care = 1)", "gray(dont_care = 7)"})
        CHECK(Coding::named(text).text() == text);
    CHECK(Coding() == Coding::natural);
    CHECK(Coding::named("gray(0)") == Coding::gray);
    CHECK(Coding::named("gray(1)") != Coding::gray);
    CHECK(Coding::named("gray(1)").plain() == Coding::gray);
    CHECK_THROWS_WITH_AS(Coding::named("grey"), doctest::Contains("did you mean \"gray\"?"), UserError);
    CHECK_THROWS_AS(Coding::named("real(1)"), UserError);
}

TEST_CASE("don't-care bits lengthen a string as in equation 6.15, and are removed again") {
    CHECK(unstuffed(Genome::from_string("11001"), 1) == Genome::from_string("101"));
    CHECK(unstuffed(Genome::from_string("1001110"), 2) == Genome::from_string("110"));
    CHECK(stuffed_bits(22, 1) == 43);
    CHECK(stuffed_bits(1, 5) == 1);
    RandomStream random(1, "stuffing");
    for (std::size_t bits : {1u, 2u, 33u, 100u})
        for (std::size_t dont_care : {0u, 1u, 3u}) {
            Genome genome = Genome::random(stuffed_bits(bits, dont_care), random), read = unstuffed(genome, dont_care);
            CHECK(read.size() == bits);
            for (std::size_t i = 0; i < bits; ++i)
                CHECK(read.bit(i) == genome.bit(i * (dont_care + 1)));
        }
}

TEST_CASE("don't-care bits change neither the parameters nor the fitness, and every other bit changes the parameters") {
    RandomStream random(2, "stuffed");
    auto line = make_search_problem(LineProblem{}, Coding::gray);
    auto stuffed = line->coded(Coding::named("gray(2)"));
    CHECK(stuffed->bits() == 22);
    CHECK(stuffed->coding().text() == "gray(dont_care = 2)");
    CHECK(stuffed->parameter_names() == line->parameter_names());
    auto record = line_record(4);
    std::vector<Genome> population = random_population(20, 22, random);
    std::vector<double> fitness(20);
    stuffed->fitness_of(population, record, 400, fitness);
    for (std::size_t i = 0; i < population.size(); ++i) {
        Genome plain = unstuffed(population[i], 2);
        CHECK(fitness[i] == line->fitness(plain, record, 400));
        CHECK(stuffed->error(population[i], record[1]) == line->error(plain, record[1]));
        CHECK(stuffed->decode(population[i]) == line->decode(plain));
        for (std::size_t bit = 0; bit < 22; ++bit) {
            Genome neighbour = population[i];
            neighbour.flip(bit);
            CHECK((stuffed->decode(neighbour) == stuffed->decode(population[i])) == (bit % 3 != 0));
        }
    }
    CHECK(stuffed->coded(Coding::natural)->bits() == 8);
    CHECK(stuffed->coded(Coding::named("natural(1)"))->bits() == 15);
    CHECK(minimise(PlainSphere{})->coded(Coding::named("natural(1)"))->objective()->goal == Goal::minimise);
}

TEST_CASE("with the coding \"real\", a string holds real numbers in the ranges of the fields") {
    auto sphere = minimise(PlainSphere{})->coded(Coding::real);
    Representation reals = sphere->representation();
    CHECK(reals.kind() == StringKind::real);
    CHECK(sphere->bits() == 3 * 64);
    CHECK(reals.reals().range(2).low == -4);
    Genome genome = reals.read("1 -2 0.125");
    CHECK(sphere->decode(genome) == std::vector<double>{1, -2, 0.125});
    CHECK(sphere->fitness(genome, {}, 400) == -5.015625);
    CHECK(sphere->coded(Coding::natural)->bits() == 24);
}

TEST_CASE("a coding that has no meaning for a problem is refused") {
    CHECK_THROWS_WITH_AS(
        make_search_problem(LineProblem{})->coded(Coding::real),
        "the coding \"real\" has no meaning for this problem, which has no real numbers to breed; choose "
        "\"natural\"",
        UserError);
    CHECK_THROWS_AS(minimise(Seats{})->coded(Coding::gray), UserError);
    CHECK_THROWS_AS(maximise(Comb{})->coded(Coding::gray), UserError);
    CHECK_THROWS_WITH_AS(minimise(Seats{})->coded(Coding::named("natural(1)")),
                         "don't-care bits need binary strings, but this problem's strings are permutations", UserError);
    CHECK(maximise(Comb{})->coded(Coding::named("natural(1)"))->bits() == 8191);
}
