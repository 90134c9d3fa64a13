#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace placedpar::test {

/// A random program of processes in occam that exchange messages of random protocols, and a random machine for it. All
/// messages are in one order, and each process takes part in its messages in this order. Therefore the program has no
/// deadlock, and its output does not depend on the machine.
struct RandomTraffic {
    std::map<std::string, std::string> files; ///< "one.cfs" on one processor, "many.cfs" on several
    std::string printed;                      ///< the expected output, computed by a model in C++
};

RandomTraffic random_traffic(std::uint64_t seed);

} // namespace placedpar::test
