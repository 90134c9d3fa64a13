#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// A search problem that includes no header of gaprocs, as a problem of another room would. Its parameter is the slope
/// of a line through the origin, from 0 to 1 in 8 bits. A sample is (u, y).
struct LineProblem {
    std::size_t bits() const { return 8; }
    std::size_t channels() const { return 2; }

    template <typename G>
    double error(const G& genome, std::span<const double> sample) const {
        return sample[1] - decode(genome)[0] * sample[0];
    }
    template <typename G>
    std::vector<double> decode(const G& genome) const {
        return {static_cast<double>(genome.field(0, 8)) / 256};
    }
    std::vector<std::string> parameter_names() const { return {"slope"}; }
    std::vector<std::string> parameter_units() const { return {"1"}; }
};

/// The line problem, with errors that are accumulated from the first sample of the window on.
struct LineAlongWindow : LineProblem {
    template <typename G>
    std::vector<double> parameters_of(const G& genome) const {
        return decode(genome);
    }
    template <typename T>
    auto errors_along(std::span<const T> slope) const {
        return [slope = slope[0], sum = T(0.0)](std::span<const double> sample) mutable {
            return sum += sample[1] - slope * sample[0];
        };
    }
};

/// Returns samples of the line y = 0.59375 u, which is code 152.
inline std::vector<std::vector<double>> line_record(std::size_t samples) {
    std::vector<std::vector<double>> record;
    for (std::size_t k = 0; k < samples; ++k) {
        double u = 20 + 15 * std::sin(static_cast<double>(k));
        record.push_back({u, 152.0 / 256 * u});
    }
    return record;
}
