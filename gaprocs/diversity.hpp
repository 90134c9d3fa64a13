#pragma once

#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/representation.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

// Diversity is the mean Representation::distance() of two individuals drawn at random, divided by the greatest possible
// distance. It is 0 if all individuals are equal, and at most 1. The table shows its meaning and its expected value for
// random individuals:
//
//     binary strings   fraction of bits in which they differ                                               1/2
//     real vectors     root of the mean square distance of their numbers, in widths of the ranges      1/sqrt(6)
//     permutations     fraction of neighbours in one closed tour that are not neighbours in the other  1 - 2/(n - 1)
//
// For binary strings, diversity_within() is the nucleotide diversity of Nei and Li (1979), with bits as sites.
// diversity_between() of two populations is their d_XY. For real vectors the root mean square was chosen. So for all
// three kinds the diversity follows from the centre of each population and the distances from the centre, without a
// loop over pairs.

/// A population as points in space. For binary strings and permutations, the squared distance of two points is
/// proportional to Representation::distance(); for real vectors, to its square.
struct Spread {
    /// A coordinate: a bit, a number as a fraction of its range, or a pair of neighbours in a tour.
    struct Coordinate {
        std::uint64_t which; ///< bit, number of the vector, or pair of neighbours
        double mean;
    };
    StringKind kind;
    double greatest; ///< greatest possible squared distance
    std::size_t individuals;
    std::vector<Coordinate> centre = {}; ///< coordinates that are 0 for all individuals are left out
    double squares = 0;                  ///< sum of the squared distances from the centre
};

/// REQUIRES: all strings belong to this representation.
Spread spread_of(std::span<const Genome> population, const Representation&);

/// Returns the diversity of two different individuals of one population; 0 if there are fewer than two individuals.
double diversity_within(const Spread& population);

/// Returns the diversity of two individuals from different populations. It is the mean over all pairs of populations,
/// with equal weights. REQUIRES: at least two populations, none empty, all of the same representation.
double diversity_between(std::span<const Spread> populations);

/// Returns the fraction of the diversity that is between the populations: 1 - within / between, where `within` is the
/// mean of diversity_within(). For binary strings this is the F_ST of Hudson, Slatkin and Maddison (1992). It is near
/// 0, perhaps slightly negative by chance, if the populations are samples of one population. It is 1 if each population
/// is uniform and the populations differ. It is 0 if there is no diversity.
double fixation(double within, double between);

} // namespace placedpar
