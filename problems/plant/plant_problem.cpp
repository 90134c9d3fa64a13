#include "problems/plant/plant_problem.hpp"

namespace placedpar {

namespace {

constexpr ParameterField delay_field{.low = 1, .high = 5, .bits = 2, .whole = true}; // 1, 2, 3, 4
constexpr ParameterField part_field{.low = -1, .high = 1, .bits = 7}; // real or imaginary part of a pole or a zero
constexpr ParameterField gain_field{.low = 0, .high = 2, .bits = 7};

} // namespace

std::vector<double> parameters_of(const Plant& plant) {
    Pole pole = pole_of(plant.a1, plant.a2);
    return {static_cast<double>(plant.delay), pole.alpha, pole.beta, -plant.b1 / 2, -std::abs(plant.b1) / 2, plant.b0};
}

PlantProblem::PlantProblem() : coding_({delay_field, part_field, part_field, part_field, part_field, gain_field}) {}

} // namespace placedpar
