#pragma once

#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/representation.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

// Diversity is the mean Representation::distance() of two individuals drawn at random, divided by the greatest possible
// distance: 0 if all individuals are equal, at most 1. Its meaning, and its expected value for random individuals:
//
//     binary strings   the share of the bits in which they differ                                        1/2
//     real vectors     how far apart their numbers are, in their ranges: the root of the mean square    1/sqrt(6)
//     permutations     the share of the neighbours in one closed tour that are none in the other        1 - 2/(n - 1)
//
// For binary strings it is the nucleotide diversity of Nei and Li (1979), within one population, or their d_XY, between
// two, with bits for sites. With the root mean square for real vectors, all three can be computed from the centre of
// each population and the distances from the centre, without looking at pairs.

/// Where the individuals of a population lie, as points whose squared distances are proportional to the distances of
/// strings or tours, or the squares of those of real vectors.
struct Spread {
    /// A bit, a number in its range, or two neighbours in a tour.
    struct Coordinate {
        std::uint64_t which;
        double mean;
    };
    StringKind kind;
    double greatest; ///< greatest possible squared distance
    std::size_t individuals;
    std::vector<Coordinate> centre = {}; ///< coordinates that are 0 for all individuals are left out
    double squares = 0;                  ///< the sum of the squared distances from the centre
};

/// REQUIRES: strings of this representation.
Spread spread_of(std::span<const Genome> population, const Representation&);

/// Returns the diversity of pairs of different individuals of the population; 0 for fewer than two individuals.
double diversity_within(const Spread& population);

/// Returns the diversity of pairs of individuals from different populations: the mean over all pairs of populations,
/// with equal weights. REQUIRES: two populations at least, none of them empty, all of one representation.
double diversity_between(std::span<const Spread> populations);

/// Returns the fraction of the diversity that is between the populations: 1 - within / between, where `within` is the
/// mean of diversity_within(). For binary strings this is the F_ST of Hudson, Slatkin and Maddison (1992). It is near
/// 0, by chance slightly negative, if the populations are samples of one population; 1 if each is uniform and they
/// differ; 0 if there is no diversity.
double fixation(double within, double between);

} // namespace placedpar
