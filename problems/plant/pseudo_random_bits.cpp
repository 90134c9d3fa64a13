#include "problems/plant/pseudo_random_bits.hpp"

namespace placedpar {

PseudoRandomBits::PseudoRandomBits(std::size_t start) {
    for (std::size_t i = 0; i < start; ++i)
        next();
}

bool PseudoRandomBits::next() {
    unsigned bit = ((register_ >> 6) ^ (register_ >> 5)) & 1;
    register_ = ((register_ << 1) | bit) & 0x7f;
    return bit != 0;
}

} // namespace placedpar
