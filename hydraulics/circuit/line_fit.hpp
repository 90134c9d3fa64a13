#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace placedpar::hydraulics {

/// The thesis limits the piecewise least-squares line to 5 samples (3.1.2).
inline constexpr std::size_t line_fit_points = 5;

/// Fits least-squares lines to 5 equally spaced samples. The slope belongs to the middle sample, 2 periods before the
/// newest. (If the slope were combined with the newest sample instead, the compliance would be biased by +17 %.) The
/// slope is exact for quadratics. White noise of standard deviation sigma gives the slope a standard deviation of sigma
/// / (sqrt(10) period), which is 15.811 sigma per second at a period of 20 ms.
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
