#include "gaprocs/policies/error_matrix.hpp"

#include <algorithm>
#include <cmath>

namespace placedpar {

namespace {

// These limits keep all quotients and their sums finite. NaN counts as the greatest error.
constexpr double least_error = 1e-12, greatest_error = 1e100;

double error_of_window(std::span<const double> errors, ErrorMatrix::Sum sum) {
    double total = 0;
    for (double error : errors)
        total += sum == ErrorMatrix::Sum::plain ? error : error * error;
    double error = sum == ErrorMatrix::Sum::means ? total / static_cast<double>(errors.size()) : std::abs(total);
    return error < greatest_error ? error : greatest_error;
}

} // namespace

ErrorMatrix::ErrorMatrix(const ErrorsOfBest& bests, Sum sum) : islands_(bests.windows.size()) {
    for (std::size_t window = 0; window < islands_; ++window)
        for (std::size_t island = 0; island < islands_; ++island)
            errors_.push_back(error_of_window(bests.in_window(window, island), sum));
}

double ErrorMatrix::normalised(std::size_t window, std::size_t island, Normaliser normaliser) const {
    std::size_t own = normaliser == Normaliser::column ? island : window;
    return std::max(error(window, island), least_error) / std::max(error(own, own), least_error);
}

double ErrorMatrix::sum_over_windows(std::size_t island, Normaliser normaliser) const {
    double sum = 0;
    for (std::size_t window = 0; window < islands_; ++window)
        sum += normalised(window, island, normaliser);
    return sum;
}

double ErrorMatrix::sum_over_islands(std::size_t window, Normaliser normaliser) const {
    double sum = 0;
    for (std::size_t island = 0; island < islands_; ++island)
        sum += normalised(window, island, normaliser);
    return sum;
}

double ErrorMatrix::ratio(std::size_t island, Normaliser normaliser) const {
    return sum_over_islands(island, normaliser) / sum_over_windows(island, normaliser);
}

} // namespace placedpar
