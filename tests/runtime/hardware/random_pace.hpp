#pragma once

#include "runtime/random.hpp"
#include "runtime/time.hpp"

#include <cstdint>

namespace placedpar::test {

/// How long the programs of a random machine wait, in bits of its links: so that on slow links, too, they do something
/// in the middle of messages. Whole tenths of a bit make much of it happen at one moment.
class RandomPace {
public:
    RandomPace(std::int64_t bits_per_second, bool in_tenths)
        : bit_(duration_of(1, bits_per_second)), tenths_(in_tenths) {}

    Time bits(std::uint32_t count) const { return count * bit_; }
    Time less_than(std::uint32_t bits, RandomStream& random) const {
        if (tenths_)
            return random.below(10 * bits) * (bit_ / 10);
        return Time{static_cast<std::int64_t>(random.uniform() * static_cast<double>(bits * bit_.count()))};
    }
    Time pause(RandomStream& random) const { return less_than(random.chance(0.7) ? 20 : 600, random); }

private:
    Time bit_;
    bool tenths_;
};

} // namespace placedpar::test
