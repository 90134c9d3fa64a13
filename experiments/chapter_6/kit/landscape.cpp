#include "experiments/chapter_6/kit/landscape.hpp"

#include "experiments/chapter_6/kit/plant_runs.hpp"
#include "problems/plant/plant_problem.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace placedpar {

namespace {

using Errors = std::vector<float>; ///< index: the string as a binary number

constexpr double same_error = 1e-3; ///< errors that differ by less, relatively, count as equal: strings for the same
                                    ///< plant, such as with beta and -beta, differ only by rounding

Genome string_numbered(std::size_t number, std::size_t bits) {
    Genome genome(bits);
    genome.set_field(0, bits, number);
    return genome;
}

/// Computes the steepest descent from every string, and stores the string at which each descent ends.
class Descents {
public:
    Descents(const Errors& errors, std::size_t bits) : end_(errors.size()) {
        for (std::size_t i = 0; i < errors.size(); ++i)
            end_[i] = better_neighbour(errors, bits, i);
        for (std::size_t i = 0; i < errors.size(); ++i)
            follow(i);
    }

    std::size_t end(std::size_t from) const { return end_[from]; }
    std::size_t minima() const {
        std::size_t count = 0;
        for (std::size_t i = 0; i < end_.size(); ++i)
            count += end_[i] == i;
        return count;
    }

private:
    /// Returns the string with the least error among `from` and the strings that differ from it in one bit.
    static std::uint32_t better_neighbour(const Errors& errors, std::size_t bits, std::size_t from) {
        std::size_t best = from;
        for (std::size_t bit = 0; bit < bits; ++bit)
            if (std::size_t other = from ^ (std::size_t{1} << bit); errors[other] < errors[best])
                best = other;
        return static_cast<std::uint32_t>(best);
    }

    /// Follows the descent from a string to its end. The descent always ends, because each step lowers the error.
    void follow(std::size_t from) {
        std::size_t end = from;
        while (end_[end] != end)
            end = end_[end];
        for (std::size_t at = from; end_[at] != end;)
            at = std::exchange(end_[at], static_cast<std::uint32_t>(end));
    }

    std::vector<std::uint32_t> end_;
};

bool is_good(const PlantProblem& problem, const Recoding& reading, std::size_t string) {
    PoleZeroPlant plant = problem.plant(reading.to_problem(string_numbered(string, reading.length())));
    Pole pole = pole_of(Plant().a1, Plant().a2);
    return std::hypot(plant.alpha - pole.alpha, std::abs(plant.beta) - pole.beta) < PlantOutcome::near_the_pole;
}

/// Counts the strings whose number satisfies the condition `is`.
template <class Is>
double count_strings(std::size_t strings, Is is) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < strings; ++i)
        count += is(i);
    return static_cast<double>(count);
}

std::vector<std::size_t> best_strings(const Errors& errors) {
    double least = *std::ranges::min_element(errors);
    std::vector<std::size_t> best;
    for (std::size_t i = 0; i < errors.size(); ++i)
        if (errors[i] <= least * (1 + same_error))
            best.push_back(i);
    return best;
}

double correlation_with_difference(const Errors& errors, const std::vector<std::size_t>& best) {
    double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_yy = 0, sum_xy = 0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        int nearest = std::numeric_limits<int>::max();
        for (std::size_t each : best)
            nearest = std::min(nearest, std::popcount(each ^ i));
        double x = nearest, y = std::log10(static_cast<double>(errors[i]) + 1e-9);
        n += 1;
        sum_x += x, sum_y += y, sum_xx += x * x, sum_yy += y * y, sum_xy += x * y;
    }
    double of_x = sum_xx - sum_x * sum_x / n, of_y = sum_yy - sum_y * sum_y / n;
    return (sum_xy - sum_x * sum_y / n) / std::sqrt(of_x * of_y);
}

Errors errors_of_all(const Recoding& reading, const WindowMoments& moments) {
    Errors errors(std::size_t{1} << reading.length());
    for (std::size_t i = 0; i < errors.size(); ++i)
        errors[i] = static_cast<float>(moments.squared_error(reading.to_problem(string_numbered(i, reading.length()))));
    return errors;
}

/// Returns the string whose parameters are the nearest to the parameters of the plant.
Genome string_of_plant(const ParameterCoding& coding) {
    std::vector<double> parameters = parameters_of(Plant());
    Genome genome(coding.bits());
    for (std::size_t i = 0, first = 0; i < parameters.size(); first += coding.field(i++).bits) {
        const ParameterField& field = coding.field(i);
        auto code = std::lround((parameters[i] - field.low) / field.resolution());
        genome.set_field(first, field.bits, static_cast<std::uint64_t>(code));
    }
    return genome;
}

} // namespace

WindowMoments::WindowMoments(std::span<const Sample> window)
    : channels_(window.front().size()), products_(channels_ * channels_) {
    for (const Sample& sample : window)
        for (std::size_t i = 0; i < channels_; ++i)
            for (std::size_t j = 0; j < channels_; ++j)
                products_[i * channels_ + j] += sample[i] * sample[j];
}

double WindowMoments::squared_error(const Genome& genome) const {
    auto weights = problem_.plant(genome).weights();
    auto weight = [&](std::size_t channel) { return channel == 0 ? 1 : -weights[channel - 1]; };
    double sum = 0;
    for (std::size_t i = 0; i < channels_; ++i)
        if (double of_i = weight(i); of_i != 0)
            for (std::size_t j = 0; j < channels_; ++j)
                sum += of_i * weight(j) * products_[i * channels_ + j];
    return std::max(sum, 0.0);
}

std::vector<double> fitness_by_low_bits(double noise, std::uint64_t seed) {
    std::vector<Sample> samples = plant_record({.noise = noise}, RandomStream(seed, "plant"));
    const WindowSettings window = plant_settings(2).window;
    WindowMoments moments(std::span<const Sample>(samples).first(window.length));
    Genome string = string_of_plant(PlantProblem().coding());
    std::vector<double> fitness(std::size_t{1} << (5 * low_bits));
    for (std::size_t i = 0; i < fitness.size(); ++i) {
        for (std::size_t parameter = 0; parameter < 5; ++parameter)
            string.set_field(6 + 7 * parameter, low_bits, i >> (low_bits * parameter) & 7);
        fitness[i] = window.bias * static_cast<double>(window.length) - moments.squared_error(string);
    }
    return fitness;
}

LandscapeFacts enumerate_landscape(const Recoding& reading, std::uint64_t seed) {
    std::vector<Sample> samples = plant_record({}, RandomStream(seed, "plant"));
    const WindowSettings window = plant_settings(2).window;
    Errors errors = errors_of_all(reading, WindowMoments(std::span(samples).first(window.length)));
    Descents descents(errors, reading.length());
    std::vector<std::size_t> best = best_strings(errors);
    auto all = static_cast<double>(errors.size());
    PlantProblem problem;
    std::vector<bool> good(errors.size());
    for (std::size_t i = 0; i < errors.size(); ++i)
        good[i] = is_good(problem, reading, i);
    double most = window.bias * static_cast<double>(window.length);
    auto ends_best = [&](std::size_t i) { return std::ranges::binary_search(best, descents.end(i)); };
    return {.fit_percent = 100 / all * count_strings(errors.size(), [&](std::size_t i) { return errors[i] < most; }),
            .minima = descents.minima(),
            .optimum_percent = 100 / all * count_strings(errors.size(), ends_best),
            .good_percent =
                100 / all * count_strings(errors.size(), [&](std::size_t i) { return good[descents.end(i)]; }),
            .good_strings = count_strings(errors.size(), [&](std::size_t i) { return good[i]; }),
            .correlation = correlation_with_difference(errors, best)};
}

} // namespace placedpar
