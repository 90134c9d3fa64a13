#pragma once

#include "gaprocs/policies/policy.hpp"
#include "gaprocs/representation/representation.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

namespace placedpar {

// Problems of binary strings; all objectives are maximised.

/// The objective is the number of ones.
struct OneMax {
    static constexpr std::string_view name = "one-max", about = "the number of ones; each bit counts independently";
    std::size_t bits = 100;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"bits", &OneMax::bits, 1, 1e6, "length of the string"});
    }
    BitString representation() const { return BitString(bits); }
    double objective(const Genome& genome) const;
    double optimum() const { return static_cast<double>(bits); }
};

/// Deceptive traps (D. Goldberg, "Simple genetic algorithms and the minimal, deceptive problem", 1987; K. Deb and D.
/// Goldberg, "Analyzing deception in trap functions", 1993). The objective is a sum over the blocks: a block of ones
/// adds `size`, any other block adds the number of its zeros minus 1. So while a block is not all ones, each bit that
/// becomes 0 improves the objective, although the optimum is all ones.
struct Trap {
    static constexpr std::string_view name = "trap",
                                      about = "deceptive traps: in each block, single bit changes lead away from the "
                                              "optimum";
    std::size_t blocks = 10, size = 5;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"blocks", &Trap::blocks, 1, 1e5, "number of blocks in a string"},
                          PolicyNumber{"size", &Trap::size, 2, 64, "number of bits in a block"});
    }
    BitString representation() const { return BitString(blocks * size); }
    double objective(const Genome& genome) const;
    double optimum() const { return static_cast<double>(blocks * size); }
};

/// The objective is a sum of one contribution for each bit of the string. A contribution depends on the bit and the k
/// bits after it. The bits form a ring, so after the last bit comes the first.
class Landscape {
public:
    /// `contributions` holds 2^(k + 1) numbers for each bit i. The bits i ... i + k, read as a binary number, are the
    /// index of the contribution among these numbers. REQUIRES: bits > k; contributions.size() == bits * 2^(k + 1).
    Landscape(std::size_t bits, std::size_t k, std::vector<double> contributions);

    BitString representation() const { return BitString(bits_); }
    double objective(const Genome& genome) const;
    /// Returns the exact optimum, by dynamic programming; nothing if this would take more than 2^24 steps.
    std::optional<double> optimum() const;

private:
    double contribution(std::size_t place, std::size_t neighbourhood) const {
        return contributions_[(place << (k_ + 1)) + neighbourhood];
    }
    double best_from(std::size_t first) const;

    std::size_t bits_, k_;
    std::vector<double> contributions_;
};

/// NK landscapes (S. Kauffman, "The Origins of Order", 1993) in which the contribution of a bit depends on the bit and
/// the `k` bits after it. The contributions are uniform random numbers between 0 and 1 / `bits`.
struct NkLandscape {
    static constexpr std::string_view name = "nk",
                                      about = "a landscape in which the value of each bit depends on `k` neighbours, "
                                              "drawn from a seed";
    std::size_t bits = 32, k = 4, seed = 1;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"bits", &NkLandscape::bits, 1, 10000, "length of the string: N"},
                          PolicyNumber{"k", &NkLandscape::k, 0, 8,
                                       "number of neighbours on which a bit's value depends: K, less than N"},
                          PolicyNumber{"seed", &NkLandscape::seed, 0, 1e15, "seed of the table of values"});
    }
    /// Returns the landscape with contributions drawn from `seed`. Throws UserError unless k < bits.
    Landscape problem() const;
};

} // namespace placedpar
