#include "experiments/chapter_5/kit/tracking.hpp"

#include "text/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace placedpar {

namespace {

constexpr std::size_t change_generation = 200, longest_delay = 400, longest_lag = 250;
// The first generation in which the found alpha is compared with the shifted true alpha.
constexpr std::size_t lag_from = 150;

Pole true_pole(const PlantChange& change, std::size_t generation) {
    return pole_of(a1_at(change, static_cast<double>(generation)), Plant{}.a2);
}

double running_median(std::span<const Pole> found, std::size_t generation) {
    std::size_t first = generation < 5 ? 0 : generation - 5, end = std::min(generation + 6, found.size());
    std::vector<double> near;
    for (std::size_t g = first; g < end; ++g)
        near.push_back(found[g].alpha);
    return median(near);
}

/// Returns the value of alpha when this share of its change is complete.
double alpha_on_the_way(const PlantChange& change, double share) {
    double before = true_pole(change, 0).alpha, after = true_pole(change, 600).alpha;
    return before + share * (after - before);
}

double delay_until(std::span<const Pole> found, double alpha) {
    for (std::size_t delay = 0; delay < longest_delay && change_generation + delay < found.size(); ++delay)
        if (running_median(found, change_generation + delay) <= alpha)
            return static_cast<double>(delay);
    return longest_delay;
}

double best_lag(std::span<const Pole> found, const PlantChange& change) {
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t lag = 0; lag <= longest_lag; ++lag) {
        double error = 0;
        for (std::size_t g = lag_from; g < found.size(); ++g) {
            double alpha = a1_at(change, static_cast<double>(g < lag ? 0 : g - lag)) / 2;
            error += (found[g].alpha - alpha) * (found[g].alpha - alpha);
        }
        if (error < least) {
            least = error;
            best = lag;
        }
    }
    return static_cast<double>(best);
}

double squared_distance(const Pole& one, const Pole& other) {
    double real = one.alpha - other.alpha, imaginary = one.beta - other.beta;
    return real * real + imaginary * imaginary;
}

double pole_error(std::span<const Pole> found, const PlantChange& change, std::size_t first, std::size_t end) {
    double squares = 0;
    for (std::size_t g = first; g < end; ++g)
        squares += squared_distance(found[g], true_pole(change, g));
    return std::sqrt(squares / static_cast<double>(end - first));
}

double deviation_in_time(std::span<const Pole> found, std::size_t first, std::size_t end) {
    std::vector<double> alphas;
    for (const Pole& pole : found.subspan(first, end - first))
        alphas.push_back(pole.alpha);
    return deviation(alphas);
}

} // namespace

TrackingFigures track(std::span<const Pole> found, const PlantChange& change) {
    return {delay_until(found, alpha_on_the_way(change, 0.2)),
            delay_until(found, alpha_on_the_way(change, 0.63)),
            best_lag(found, change),
            pole_error(found, change, 100, 200),
            pole_error(found, change, 200, 400),
            pole_error(found, change, 500, 600),
            deviation_in_time(found, 100, 200),
            deviation_in_time(found, 500, 600)};
}

} // namespace placedpar
