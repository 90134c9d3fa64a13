#pragma once

#include "gaprocs/representation/genome.hpp"
#include "identification/on_line/set_problem.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar::identification {

/// Computes the fitness of the strings of several generations over one window of samples. Remembers the fitness of
/// strings of at most `most_bits` bits, as in a search for one link's compliance. This saves time, because a converging
/// population has many equal strings.
class WindowFitness {
public:
    /// REQUIRES: the problem outlives this object.
    WindowFitness(const SetProblem& problem, std::span<const SetSample> window, double bias);

    /// Returns the same values as SetProblem::fitness(), bit by bit.
    std::vector<double> operator()(std::span<const Genome> strings);

private:
    static constexpr std::size_t most_bits = 12;

    std::vector<Genome> fresh_of(std::span<const Genome> strings);
    void evaluate(std::span<const Genome> strings);

    const SetProblem& problem_;
    std::vector<hydraulics::CircuitTerms> window_;
    double bias_;
    std::vector<std::uint8_t> met_; ///< whether a string has been seen; the index is the string as a number
    std::vector<double> known_;     ///< fitness of each string that was seen
};

} // namespace placedpar::identification
