#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace placedpar::test {

/// A small world of masters on a VMEbus, in units of time: a word takes `word`, arbitration `arbitration`.
struct BusWorld {
    struct Block {
        int pause;
        int words;
    };
    struct Master {
        int level, slot;
        bool on_request;
        std::vector<Block> blocks; ///< each is asked for when the one before has been moved and the pause is over
    };
    enum class Rule { priority, round_robin, single_level };
    Rule rule;
    int word, arbitration;
    std::vector<Master> masters;

    /// Enough to build it again.
    std::string text() const;
};

/// The ends of each master's blocks, one word and one unit of time after the other: the reference by which the bus is
/// tested.
std::vector<std::vector<int>> ends_of_blocks(const BusWorld&);

} // namespace placedpar::test
