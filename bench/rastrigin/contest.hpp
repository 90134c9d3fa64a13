#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <vector>

// This header declares the task of every contestant. It does not include Boost, since a rival may use another version
// of Boost.

namespace placedpar {

/// Rastrigin's function in 20 dimensions. The search ends when the value of an individual is below 1e-6, or when all
/// evaluations are used. objective() then throws Stop, even within a generation, so that the evaluations of all
/// contestants are counted in the same way.
class Valley {
public:
    static constexpr std::size_t dimensions = 20;
    static constexpr double low = -5.12, high = 5.12, target = 1e-6;

    struct Stop {};

    explicit Valley(std::uint64_t most_evaluations) : most_evaluations_(most_evaluations) {}

    double objective(std::span<const double> x) {
        double value = 10 * static_cast<double>(dimensions);
        for (double each : x)
            value += each * each - 10 * std::cos(2 * std::numbers::pi * each);
        ++evaluations_;
        reached_ = value < target;
        if (reached_ || evaluations_ == most_evaluations_)
            throw Stop();
        return value;
    }
    std::uint64_t most_evaluations() const { return most_evaluations_; }
    std::uint64_t evaluations() const { return evaluations_; }
    bool reached() const { return reached_; }

private:
    std::uint64_t most_evaluations_;
    std::uint64_t evaluations_ = 0;
    bool reached_ = false;
};

struct Contestant {
    std::string name;
    void (*descend)(Valley&, std::uint64_t seed); ///< runs until objective() throws Stop
};

std::vector<Contestant> ours();
std::vector<Contestant> pagmo();

} // namespace placedpar
