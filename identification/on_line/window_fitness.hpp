#pragma once

#include "gaprocs/representation/genome.hpp"
#include "identification/on_line/set_problem.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar::identification {

/// The fitness of the strings of several generations over one window. Short strings, those of one link, are each
/// evaluated once: a population that converges has many twice, and most that the generations before had.
class WindowFitness {
public:
    /// REQUIRES: the problem outlives this.
    WindowFitness(const SetProblem& problem, std::span<const SetSample> window, double bias);

    /// As SetProblem::fitness(), to the bit.
    std::vector<double> operator()(std::span<const Genome> strings);

private:
    static constexpr std::size_t most_bits = 12;

    std::vector<Genome> fresh_of(std::span<const Genome> strings);
    void evaluate(std::span<const Genome> strings);

    const SetProblem& problem_;
    std::vector<hydraulics::CircuitTerms> window_;
    double bias_;
    std::vector<std::uint8_t> met_; ///< by the string as a number
    std::vector<double> known_;     ///< of those
};

} // namespace placedpar::identification
