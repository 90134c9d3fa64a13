#pragma once

#include "gaprocs/fitness.hpp"
#include "identification/circuit_problem.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

// This header declares the task and the results of every contestant. The only Boost headers that it includes are
// containers, since a rival may use another version of Boost.

namespace placedpar {

/// The task: identify the boom's compliance from its record as in chapter 3. From the fifth sample on, each new sample
/// gives a window of at most ten samples, with five generations of 120 individuals.
struct Transient {
    std::vector<hydraulics::LinkSample> record;
    hydraulics::FlowConstants flow;
    std::uint64_t seed = 0; // seed of the contestant's random numbers

    static constexpr std::size_t population = 120, window = 10, first = 5, trials = 5;
    static constexpr double bias = 400, crossover = 0.8, mutation = 0.01;
    static constexpr double largest = CircuitProblem::largest_in3_per_psi;
    static constexpr std::size_t bits = CircuitProblem::usual_bits;

    /// Returns the number of windows. Each window gets `trials` generations.
    std::size_t windows() const { return record.size() + 1 - first; }
    std::span<const hydraulics::LinkSample> window_at(std::size_t number) const {
        std::size_t end = first + number, length = end < window ? end : window;
        return std::span(record).subspan(end - length, length);
    }
    /// Computes equations 3.5 to 3.8 by hand-written code, which is the fastest way for a contestant without the
    /// library.
    double error(double compliance, const hydraulics::LinkSample& sample) const {
        const double k = flow.orifice_in3_per_s_in2_sqrt_psi;
        double inlet = sample.piston_flow_in3_per_s + sample.inlet_slope_psi_per_s * compliance;
        double root = inlet / (k * sample.inlet_in2);
        double pump_psi = root * root + sample.inlet_psi;
        double bypass = k * sample.bypass_in2 * std::sqrt(std::max(pump_psi - flow.tank_psi, 0.0));
        return std::abs(flow.pump_in3_per_s - std::abs(inlet) - bypass);
    }
    double fitness(double compliance, std::span<const hydraulics::LinkSample> samples) const {
        double sum = 0;
        for (const hydraulics::LinkSample& sample : samples)
            sum += fitness_term(bias, error(compliance, sample));
        return sum;
    }
};

struct Answer {
    double compliance; // compliance of the best individual in the last generation; for the service, the median that it
                       // reports
    std::uint64_t error_evaluations; // number of errors computed, each for one individual at one sample; 0: not counted
};

struct Contestant {
    std::string name;
    Answer (*identify)(const Transient&);
    // Contestants with the same number use the same algorithm and random stream, and must give the same bits.
    int way = -1;
};

std::vector<Contestant> ours();
std::vector<Contestant> galib();
std::vector<Contestant> pagmo();

} // namespace placedpar
