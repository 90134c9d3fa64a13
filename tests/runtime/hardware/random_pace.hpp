#pragma once

#include "runtime/random.hpp"
#include "runtime/time.hpp"

#include <cstdint>

namespace placedpar::test {

/// Chooses the waits of a random machine's programs, in bits of its links. So programs act in the middle of messages
/// even on slow links. If the pace is in tenths, waits are whole tenths of a bit, so that many events coincide.
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
