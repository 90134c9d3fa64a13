#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace placedpar::hydraulics {

/// The number of samples to which a line is fitted; the thesis uses 5 (3.1.2).
inline constexpr std::size_t line_fit_points = 5;

/// Fits a least-squares line to 5 equally spaced samples, to get the rate of change of a noisy pressure or angle. The
/// slope belongs to the middle sample, 2 periods before the newest. Used with the newest sample instead, the slope
/// would make identified compliances 17 % too large. The slope is exact for quadratics. White noise of standard
/// deviation sigma gives the slope a standard deviation of sigma / (sqrt(10) period). At a period of 20 ms, this is
/// 15.811 sigma per second.
class CentredLineFit {
public:
    /// Throws std::invalid_argument unless period_s > 0.
    explicit CentredLineFit(double period_s);

    /// Returns the slope per second. REQUIRES: has_slope(values.size(), centre).
    double slope_per_s(std::span<const double> values, std::size_t centre) const;

    /// Returns whether there are two samples on either side of `centre`.
    static bool has_slope(std::size_t size, std::size_t centre) {
        constexpr std::size_t side = line_fit_points / 2;
        return centre >= side && centre + side < size;
    }

private:
    std::array<double, line_fit_points> slope_weights_;
};

} // namespace placedpar::hydraulics
