// Counts the operations of the search's and of the recursion's own code, by a number that counts.

#include "experiments/chapter_5/kit/computation.hpp"
#include "experiments/chapter_5/kit/least_squares.hpp"
#include "problems/plant/plant_problem.hpp"

#include <doctest/doctest.h>

#include <array>

using namespace placedpar;

namespace {

Operations counted{};

class Counting {
public:
    Counting(double value = 0) : value_(value) {}
    explicit operator int() const { return static_cast<int>(value_); }

    Counting operator-() const { return -value_; }
    friend Counting abs(Counting a) { return a.value_ < 0 ? -a.value_ : a.value_; }
    friend Counting operator+(Counting a, Counting b) { return ++counted.additions, a.value_ + b.value_; }
    friend Counting operator-(Counting a, Counting b) { return ++counted.additions, a.value_ - b.value_; }
    friend Counting operator*(Counting a, Counting b) { return ++counted.multiplications, a.value_ * b.value_; }
    friend Counting operator/(Counting a, Counting b) { return ++counted.divisions, a.value_ / b.value_; }
    Counting& operator+=(Counting b) { return *this = *this + b; }
    Counting& operator-=(Counting b) { return *this = *this - b; }

private:
    double value_;
};

void check_counted(const Operations& expected) {
    CHECK(counted.additions == expected.additions);
    CHECK(counted.multiplications == expected.multiplications);
    CHECK(counted.divisions == expected.divisions);
    counted = {};
}

} // namespace

TEST_CASE("the fitness of an individual takes as many operations as stated") {
    PlantProblem problem;
    const std::vector<double> sample(plant_channels, 1);
    for (std::size_t window : {1u, 10u, 30u}) {
        auto value = [&](std::size_t i) {
            const ParameterField& field = problem.coding().field(i);
            return Counting(field.low) + Counting(field.resolution()) * 0.0;
        };
        PoleZeroPlantOf<Counting> plant{value(0), value(1), value(2), value(3), value(4), value(5)};
        std::array weights = plant.weights();
        Counting fitness;
        for (std::size_t i = 0; i < window; ++i) {
            auto error = problem.error_of<Counting>(weights, sample);
            fitness += 10 - error * error;
        }
        check_counted(operations_of_fitness(static_cast<double>(window)));
    }
}

TEST_CASE("recursive least squares takes as many operations as stated") {
    for (std::size_t unknowns : {1u, 2u, 5u, 7u}) {
        RecursiveEstimate<Counting> estimate(unknowns);
        const std::vector<Counting> inputs(unknowns, 1.0);
        Counting error = estimate.take(inputs, 1.0, 0.9), squared_error;
        squared_error = 0.9 * squared_error + error * error;
        check_counted(operations_of_recursion(static_cast<double>(unknowns)));
    }
}
