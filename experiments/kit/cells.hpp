#pragma once

#include "experiments/kit/reading.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

/// A figure that is judged by how far it is from the known one, in the cell's unit.
Cell judged_cell(std::string row, std::string column, std::string unit, double known, double value, double tolerance,
                 int decimals);
/// A figure that is printed, beside a known one or alone.
Cell compared_cell(std::string row, std::string column, std::string unit, double known, double value, int decimals);
Cell plain_cell(std::string row, std::string column, std::string unit, double value, int decimals);
/// A figure that is judged from one side: beside a known one that need not be met, or alone.
Cell at_least(double bound, Cell cell);
Cell at_most(double bound, Cell cell);

/// Standard deviation of a sample. REQUIRES: two values at least.
double deviation(const std::vector<double>& values);
double mean(const std::vector<double>& values);
/// By how much two samples' shares of so many each may differ, in percent, where one is known: three deviations of the
/// difference, sqrt(2 p (1 - p) / n); p by Agresti and Coull's two successes and two failures more, so that a share of
/// 0 or 100 % scatters too. As a figure of 50 to 300 seeds is known, as if of as many.
double share_tolerance(double known_percent, std::size_t records);
/// The same of a standard deviation of n Gaussian values, known to `rounding`: three times known / sqrt(n - 1), and
/// that.
double deviation_tolerance(double known, std::size_t records, double rounding);

/// How many of the values are at most `limit`, in percent.
double percent_within(const std::vector<double>& values, double limit);

} // namespace placedpar
