#pragma once

#include <Random123/philox.h>

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace placedpar {

/// A stream of random numbers that depends only on the run's seed and the path of the process, so that it is the same
/// in every placement, order of events and number of processors. Counter-based, Philox 4x32-10 (J. Salmon et al.,
/// "Parallel random numbers: as easy as 1, 2, 3", 2011). Meets std::uniform_random_bit_generator.
class RandomStream {
public:
    using result_type = std::uint32_t;

    RandomStream(std::uint64_t seed, std::string_view path);

    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }
    result_type operator()() {
        if (drawn_from_block_ == 4)
            next_block();
        return block_[drawn_from_block_++];
    }
    /// Draws the next numbers, the same as single calls would.
    void fill(std::span<result_type> numbers);

    /// Uniform in [0, 1), a multiple of 2^-32.
    double uniform() { return (*this)() * 0x1p-32; }
    /// Uniform in 0 ... n - 1 without bias. REQUIRES: n > 0.
    std::uint32_t below(std::uint32_t n);
    /// From the standard normal distribution, by Box and Muller's cosine: two uniform numbers.
    double normal();
    /// True with the given probability.
    bool chance(double probability) { return uniform() < probability; }

private:
    void next_block();

    using Philox = r123::Philox4x32;
    Philox::key_type key_;
    Philox::ctr_type counter_;
    Philox::ctr_type block_;
    unsigned drawn_from_block_;
};

} // namespace placedpar
