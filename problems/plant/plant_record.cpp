#include "problems/plant/plant_record.hpp"

#include "problems/plant/pseudo_random_bits.hpp"
#include "runtime/random.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace placedpar {

namespace {

constexpr std::size_t samples_per_bit = 4;

void validate_experiment(const PlantExperiment& experiment) {
    if (experiment.window == 0)
        throw UserError("the plant's record begins with a window of 0 samples, expected at least 1");
    if (experiment.per_sample == 0)
        throw UserError("the number of generations per sample is 0, expected at least 1");
    if (!(experiment.noise >= 0) || !std::isfinite(experiment.noise))
        throw UserError(fmt::format("the plant's noise is {}, expected 0 or a positive number", experiment.noise));
}

/// Returns a Gaussian number by the method of Box and Muller. Draws two numbers.
double gaussian(RandomStream& random) {
    double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

/// Returns the input u(0), u(1), ..., each 1 or -1.
std::vector<double> input_signal(std::size_t samples, RandomStream& random) {
    PseudoRandomBits bits(random.below(PseudoRandomBits::period));
    std::vector<double> input;
    while (input.size() < samples)
        input.insert(input.end(), samples_per_bit, bits.next() ? 1 : -1);
    input.resize(samples);
    return input;
}

/// Returns signal[k - delay]. Returns 0 if k < delay.
double past(const std::vector<double>& signal, std::size_t k, std::size_t delay) {
    return k < delay ? 0 : signal[k - delay];
}

class PlantRun {
public:
    PlantRun(const PlantExperiment& experiment, std::size_t samples, RandomStream& random)
        : experiment_(experiment), input_(input_signal(samples, random)) {
        for (std::size_t k = 0; k < samples; ++k) {
            noise_.push_back(experiment.noise > 0 ? experiment.noise * gaussian(random) : 0);
            output_.push_back(next_output(k));
        }
    }

    std::vector<double> sample(std::size_t k) const {
        std::vector<double> sample{past(output_, k, 0), past(output_, k, 1), past(output_, k, 2)};
        for (std::size_t delay = 1; delay <= plant_inputs; ++delay)
            sample.push_back(past(input_, k, delay));
        return sample;
    }

    /// Returns the index of the sample that arrives in generation 0.
    std::size_t first() const { return experiment_.settling + experiment_.window - 1; }

private:
    double next_output(std::size_t k) const {
        Plant plant;
        double a1 = a1_at(experiment_.change, generation_of(k));
        double response = a1 * past(output_, k, 1) + plant.a2 * past(output_, k, 2) +
                          plant.b0 * (past(input_, k, plant.delay) + plant.b1 * past(input_, k, plant.delay + 1));
        return response + past(noise_, k, 0) + experiment_.colour[0] * past(noise_, k, 1) +
               experiment_.colour[1] * past(noise_, k, 2);
    }
    double generation_of(std::size_t k) const {
        return k < first() ? 0 : static_cast<double>((k - first()) * experiment_.per_sample);
    }

    PlantExperiment experiment_;
    std::vector<double> input_, noise_, output_;
};

} // namespace

Pole pole_of(double a1, double a2) { return {a1 / 2, std::sqrt(-a2 - a1 * a1 / 4)}; }

double a1_at(const PlantChange& change, double generation) {
    constexpr double at_first = Plant().a1;
    if (generation < change.from)
        return at_first;
    double share = change.lasts > 0 ? std::min((generation - change.from) / change.lasts, 1.0) : 1;
    return at_first + share * (change.a1 - at_first);
}

std::vector<std::vector<double>> plant_record(const PlantExperiment& experiment, RandomStream random) {
    validate_experiment(experiment);
    std::size_t all = experiment.settling + experiment.record_length();
    PlantRun run(experiment, all, random);
    std::vector<std::vector<double>> record;
    for (std::size_t k = experiment.settling; k < all; ++k)
        record.push_back(run.sample(k));
    return record;
}

} // namespace placedpar
