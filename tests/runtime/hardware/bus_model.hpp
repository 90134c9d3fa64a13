#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace placedpar::test {

/// A small world of masters on a VMEbus, in abstract units of time.
struct BusWorld {
    struct Block {
        int pause;
        int words;
    };
    struct Master {
        int level, slot;
        bool on_request;
        std::vector<Block> blocks; ///< each is requested after a pause, which begins when the previous block has been
                                   ///< moved
    };
    enum class Rule { priority, round_robin, single_level };
    Rule rule;
    int word, arbitration;
    std::vector<Master> masters;

    /// Returns a text from which the world can be rebuilt.
    std::string text() const;
};

/// Returns the times at which each master's blocks end. They are computed step by step, as a reference for the
/// runtime's bus.
std::vector<std::vector<int>> ends_of_blocks(const BusWorld&);

} // namespace placedpar::test
