#pragma once

#include <cstddef>

namespace placedpar {

/// A pseudo-random sequence of bits, from which the input of a plant is made. It has the period 127, and comes from a
/// shift register of seven bits (x^7 + x^6 + 1). In each period, every pattern of seven bits occurs once, except seven
/// zeros.
class PseudoRandomBits {
public:
    static constexpr std::size_t period = 127;

    /// Starts the sequence after the first `start` bits of the period. REQUIRES: start < period.
    explicit PseudoRandomBits(std::size_t start = 0);
    bool next();

private:
    unsigned register_ = 1;
};

} // namespace placedpar
