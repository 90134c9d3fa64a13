#pragma once

// Random123's vector instructions are switched off. They would not make this code faster, and without them the header
// compiles in half the time.
#ifndef R123_USE_SSE
#define R123_USE_SSE 0
#endif
#include <Random123/philox.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace placedpar {

/// A stream of random numbers for one process. The numbers depend only on the run's seed and on the process's path,
/// that is, its full name. So a process draws the same numbers wherever it is placed. The generator is counter-based:
/// Philox 4x32-10 (J. Salmon et al., "Parallel random numbers: as easy as 1, 2, 3", 2011). The class satisfies
/// std::uniform_random_bit_generator.
class RandomStream {
public:
    using result_type = std::uint32_t;

    RandomStream(std::uint64_t seed, std::string_view path);

    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }
    result_type operator()() {
        if (drawn_ == ahead)
            compute_ahead();
        return numbers_[drawn_++];
    }
    /// Draws the next numbers. They are the same numbers that single calls would draw.
    void fill(std::span<result_type> numbers);

    /// Returns how many numbers have been drawn so far.
    std::uint64_t drawn() const;
    /// Makes the next draw return the number that follows the first `drawn` numbers of the stream.
    void go_to(std::uint64_t drawn);

    /// Returns a number that is distributed uniformly in [0, 1). It is a multiple of 2^-32.
    double uniform() { return (*this)() * 0x1p-32; }
    /// Returns a number that is distributed uniformly in 0 ... n - 1, without bias. REQUIRES: n > 0.
    std::uint32_t below(std::uint32_t n) {
        // Lemire's multiplication with rejection (ACM TOMACS 29, 2019).
        std::uint64_t product = std::uint64_t{(*this)()} * n;
        if (static_cast<std::uint32_t>(product) < n) [[unlikely]]
            reject(product, n);
        return static_cast<std::uint32_t>(product >> 32);
    }
    /// Returns a number from the standard normal distribution: the cosine value of Box and Muller's method. Draws two
    /// numbers of the stream.
    double normal();
    /// Returns true with the given probability.
    bool chance(double probability) { return uniform() < probability; }

private:
    /// How many numbers are computed at once: 16 blocks of 4, enough to fill the widest registers of a processor.
    static constexpr std::size_t ahead = 64;
    using Numbers = std::array<result_type, ahead>;

    void compute_ahead();
    void reject(std::uint64_t& product, std::uint32_t n);

    using Philox = r123::Philox4x32;
    Philox::key_type key_;
    Philox::ctr_type counter_;
    std::size_t drawn_ = ahead; ///< index in `numbers_`
    Numbers numbers_;
};

} // namespace placedpar
