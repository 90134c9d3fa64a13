#pragma once

#include "gaprocs/representation/genome.hpp"
#include "gaprocs/representation/representation.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace placedpar {

// Diversity says how different the individuals of a population are: 0 if all are equal, at most 1. It is the mean
// Representation::distance() of two individuals, divided by the greatest possible distance. For real vectors, the root
// mean square distance replaces the mean distance. The table shows what diversity measures for each kind of string, and
// the expected value for random individuals. A permutation has n places:
//
//     binary strings   fraction of bits in which they differ                                               1/2
//     real vectors     root of the mean square distance of their numbers, in widths of the ranges      1/sqrt(6)
//     permutations     fraction of neighbours in one closed tour that are not neighbours in the other  1 - 2/(n - 1)
//
// For binary strings, diversity_within() is the nucleotide diversity of Nei and Li (1979), with bits as sites, and
// diversity_between() of two populations is their d_XY. For real vectors PlacedPar uses the root mean square. Then the
// diversity of all three kinds of strings follows from the centre of each population and the distances from this
// centre, without a loop over pairs.

/// Describes a population as points in space, from which the functions below compute the diversity. For binary strings
/// and permutations, the squared distance of two points is proportional to Representation::distance(); for real
/// vectors, to its square.
struct Spread {
    /// A coordinate of a string: a bit (0 or 1), a number as a fraction of its range, or whether two places are
    /// neighbours in the tour (0 or 1).
    struct Coordinate {
        std::uint64_t which; ///< index of the bit or of the number, or code of the two places
        double mean;
    };
    StringKind kind;
    double greatest; ///< greatest possible squared distance of two individuals
    std::size_t individuals;
    std::vector<Coordinate> centre = {}; ///< mean of the individuals; omits coordinates that are 0 in all individuals
    double squares = 0;                  ///< sum of the squared distances of the individuals from the centre
};

/// Returns the population as points in space. REQUIRES: all strings belong to this representation.
Spread spread_of(std::span<const Genome> population, const Representation&);

/// Returns the diversity over all pairs of individuals of one population; 0 if there are fewer than two individuals.
double diversity_within(const Spread& population);

/// Returns the diversity over all pairs of individuals from different populations. All pairs of populations have the
/// same weight. REQUIRES: at least two populations, none empty, all of the same representation.
double diversity_between(std::span<const Spread> populations);

/// Returns 1 - `within` / `between`: the fraction of the diversity that is due to differences between populations.
/// Returns 0 if `between` is 0. `within` is the mean of diversity_within() over the populations, `between` is
/// diversity_between(). For binary strings, the result is the F_ST of Hudson, Slatkin and Maddison (1992). If the
/// populations are samples of one population, the result is near 0, perhaps slightly negative. If each population
/// consists of equal individuals and the populations differ, the result is 1.
double fixation(double within, double between);

} // namespace placedpar
