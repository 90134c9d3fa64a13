#include "problems/plant/coefficients.hpp"

#include "problems/plant/plant_record.hpp"
#include "runtime/random.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar {

namespace {

double term(FitnessForm form, double bias, double error) {
    switch (form) {
    case FitnessForm::as_printed: return bias - error;
    case FitnessForm::absolute: return bias - std::abs(error);
    case FitnessForm::square: break;
    }
    return bias - error * error;
}

} // namespace

ParameterCoding CoefficientsProblem::representation() const { return ParameterCoding(4, {-5, 5, 10}); }

double CoefficientsProblem::objective(std::span<const double> x) const {
    double sum = 0;
    for (const Sample& sample : window) {
        double predicted = x[0] * sample[1] + x[1] * sample[2] + x[2] * (sample[3] + x[3] * sample[4]);
        sum += term(form, bias, sample[0] - predicted);
    }
    return std::max(sum, 0.0);
}

CoefficientsProblem Coefficients::problem() const {
    PlantExperiment experiment{
        .change = PlantChange::none, .noise = noise, .generations = 1, .per_sample = 1, .window = samples};
    return {plant_record(experiment, RandomStream(record, "record of the plant")), static_cast<FitnessForm>(form),
            bias};
}

} // namespace placedpar
