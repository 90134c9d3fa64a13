// Tests the problem of equations 1.3 and 1.4 against sums written out by hand.

#include "problems/plant/coefficients.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace placedpar;

namespace {

constexpr std::array truth{1.5, -0.7, 1.0, 0.5};

} // namespace

TEST_CASE("the true coefficients predict a record without noise, whatever the form of the fitness") {
    for (std::size_t form : {0u, 1u, 2u})
        CHECK(Coefficients{.form = form, .samples = 30, .bias = 10}.problem().objective(truth) == doctest::Approx(300));
}

TEST_CASE("a string has 40 bits, ten for each coefficient between -5 and 5") {
    ParameterCoding coding = Coefficients().problem().representation();
    CHECK(coding.bits() == 40);
    Genome zeros(40), ones(40);
    for (std::size_t i = 0; i < 4; ++i)
        ones.set_field(10 * i, 10, 1023);
    CHECK(coding.decode(zeros) == std::vector<double>{-5, -5, -5, -5});
    CHECK(coding.decode(ones).front() == doctest::Approx(5 - 10. / 1024));
}

TEST_CASE("an error enters with its sign, its size or its square") {
    // y(k) = 3, y(k-1) = 1, y(k-2) = 2, u(k-1) = 1, u(k-2) = -1; all coefficients 1: 1 + 2 + (1 - 1) = 3, no error.
    Sample sample{3, 1, 2, 1, -1, 0, 0, 0, 0};
    constexpr std::array even{1., 1., 1., 1.}, high{2., 2., 1., 1.}, low{0., 0., 1., 1.};
    auto objective = [&](FitnessForm form, std::span<const double> x) {
        return CoefficientsProblem{{sample}, form, 10}.objective(x);
    };
    for (FitnessForm form : {FitnessForm::as_printed, FitnessForm::absolute, FitnessForm::square})
        CHECK(objective(form, even) == 10);
    CHECK(objective(FitnessForm::as_printed, high) == 13); // the error is 3 - 6
    CHECK(objective(FitnessForm::as_printed, low) == 7);   // 3 - 0
    CHECK(objective(FitnessForm::absolute, high) == 7);
    CHECK(objective(FitnessForm::absolute, low) == 7);
    CHECK(objective(FitnessForm::square, high) == 1);
    CHECK(CoefficientsProblem{{sample}, FitnessForm::square, 5}.objective(high) == 0); // not below 0
}

TEST_CASE("records differ by their number, and noise spoils the prediction") {
    CHECK(Coefficients{.record = 1}.problem().window != Coefficients{.record = 2}.problem().window);
    CHECK(Coefficients{.noise = 0.3}.problem().objective(truth) < 300);
}
