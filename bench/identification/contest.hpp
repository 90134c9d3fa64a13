#pragma once

#include "gaprocs/fitness.hpp"
#include "hydraulics/boom_problem.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

// What every contestant is given, and what it gives back. Free of Boost: a rival may bring one of its own.

namespace placedpar {

/// Identify the boom's compliance from its record, as chapter 3 does: for every new sample from the fifth on a
/// window of up to ten, and five generations of 120 individuals.
struct Transient {
    std::vector<BoomSample> record;
    FlowConstants flow;
    std::uint64_t seed = 0; // of the contestant's random numbers

    static constexpr std::size_t population = 120, window = 10, first = 5, trials = 5;
    static constexpr double bias = 400, crossover = 0.8, mutation = 0.01;
    static constexpr double largest = BoomProblem::largest_in3_per_psi;
    static constexpr std::size_t bits = BoomProblem::usual_bits;

    /// Windows that get generations.
    std::size_t windows() const { return record.size() + 1 - first; }
    std::span<const BoomSample> window_at(std::size_t number) const {
        std::size_t end = first + number, length = end < window ? end : window;
        return std::span(record).subspan(end - length, length);
    }
    double fitness(double compliance, std::span<const BoomSample> samples) const {
        double sum = 0;
        for (const BoomSample& sample : samples)
            sum += fitness_term(bias, boom_error_in3_per_s(compliance, sample, flow));
        return sum;
    }
};

struct Answer {
    double compliance;               // of the best individual of the last generation
    std::uint64_t error_evaluations; // one individual at one sample
};

struct Contestant {
    std::string name;
    Answer (*identify)(const Transient&);
};

std::vector<Contestant> ours();
std::vector<Contestant> galib();
std::vector<Contestant> pagmo();

} // namespace placedpar
