#pragma once

#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/representation.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

// Diversity is the mean Representation::distance() of two individuals drawn at random, by the greatest that there can
// be: 0 where all are alike, at most 1. What it means, and what is expected of individuals drawn at random:
//
//     binary strings   the share of the bits in which they differ                                        1/2
//     real vectors     how far apart their numbers are, in their ranges: the root of the mean square    1/sqrt(6)
//     permutations     the share of the neighbours in one closed tour that are none in the other        1 - 2/(n - 1)
//
// Of binary strings in one population it is the nucleotide diversity of Nei and Li (1979) with bits for sites, of two
// populations their d_XY. With the root mean square for real vectors all follow from the centre of each population and
// the distances from there, without looking at pairs.

/// Where the individuals of a population lie, as points whose squared distances are proportional to the distances of
/// strings or tours, or the squares of those of real vectors.
struct Spread {
    /// A bit, a number in its range, or two neighbours in a tour.
    struct Coordinate {
        std::uint64_t which;
        double mean;
    };
    StringKind kind;
    double greatest; ///< squared distance that there can be
    std::size_t individuals;
    std::vector<Coordinate> centre = {}; ///< those that are 0 for all are left out
    double squares = 0;                  ///< the sum of the squared distances from the centre
};

/// REQUIRES: strings of this representation.
Spread spread_of(std::span<const Genome> population, const Representation&);

/// Of two different individuals of the population. 0 for fewer than two individuals.
double diversity_within(const Spread& population);

/// Of two individuals from different populations, over the pairs of populations, each with the same weight.
/// REQUIRES: two populations at least, none of them empty, all of one representation.
double diversity_between(std::span<const Spread> populations);

/// Which part of the diversity is between the populations: 1 - within / between, with the mean of diversity_within().
/// Of binary strings the F_ST of Hudson, Slatkin and Maddison (1992). Near 0 where the populations are samples of one,
/// 1 where each is uniform and they differ, 0 where there is no diversity. Slightly negative by chance.
double fixation(double within, double between);

} // namespace placedpar
