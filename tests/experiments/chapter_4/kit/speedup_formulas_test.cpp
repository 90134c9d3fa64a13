#include "experiments/chapter_4/kit/speedup_formulas.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

TEST_CASE("speedups with and without communication agree with figures computed by hand") {
    CHECK(formula_c_1({.evaluating = 8, .breeding = 1, .communication = 3}, 4) == 1.5); // 9 / (2 + 1 + 3)
    CHECK(formula_c_1({.evaluating = 80, .breeding = 10}, 4) == 3);                     // 90 / (20 + 10)
    CHECK(formula_4_9(8, 4) == 3);                                                      // 9 / 3
    CHECK(formula_4_9(8, 1) == 1);
    CHECK(formula_4_9(24, 6) == 5); // 25 / 5
}

TEST_CASE("Table E.1 gives the thesis's speedup of three, and equation E.2 its speedup of twelve") {
    // 97 ms over 86.4 / 4 + 10.5 + 1.89 = 33.99 ms
    CHECK(formula_c_1({.evaluating = 86.4, .breeding = 10.5, .communication = 1.89}, 4) ==
          doctest::Approx(2.851).epsilon(.001));
    CHECK(120 / 30 * formula_4_9(8, 4) == 12);
}

TEST_CASE("equation 4.10 is equation 4.9 with alpha processors, whole or rounded up") {
    CHECK(formula_4_10(8) == 4.5);
    CHECK(formula_4_9(8, 8) == 4.5);
    CHECK(formula_4_10(8.5) == 4.75);
    CHECK(formula_4_9(8.5, 9) == doctest::Approx(4.886).epsilon(.001)); // 9.5 / 1.9444
    CHECK(formula_4_9(8.5, 8) == doctest::Approx(4.606).epsilon(.001)); // 9.5 / 2.0625, below 4.75
}

TEST_CASE("efficiency is speedup divided by the number of processors") {
    CHECK(formula_c_2(3, 4) == .75);
    CHECK(formula_c_2(formula_4_10(8), 8) == .5625);
    CHECK(formula_c_2(formula_4_10(8), 9) == .5); // alpha slaves, and a master that only breeds
    CHECK(formula_c_2(formula_pipelined(8, 8), 8) == 1);
    CHECK(formula_c_2(formula_pipelined(8, 18), 18) == .5); // 9 / 18
}

TEST_CASE("no formula exceeds the number of processors or the limit of the breeding master") {
    for (double alpha : {0.5, 1.0, 8.0, 24.0})
        for (double processors : {1.0, 2.0, 16.0, 1000.0}) {
            CHECK(formula_4_9(alpha, processors) <= formula_pipelined(alpha, processors));
            CHECK(formula_pipelined(alpha, processors) <= processors);
            CHECK(formula_pipelined(alpha, processors) <= alpha + 1);
            CHECK(formula_c_1({.evaluating = alpha, .breeding = 1, .communication = 0.1}, processors) <
                  formula_4_9(alpha, processors));
        }
    CHECK(formula_4_9(8, 1e9) == doctest::Approx(9)); // an unlimited number of slaves
}
