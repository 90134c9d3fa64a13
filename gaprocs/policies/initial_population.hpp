#pragma once

#include "gaprocs/policies/policy.hpp"

#include <string_view>
#include <tuple>

namespace placedpar {

/// Every string is drawn by the search.
struct RandomStart {
    static constexpr std::string_view name = "random", about = "every string is drawn", source = "thesis 1.1";
    static constexpr std::tuple<> numbers() { return {}; }
};

/// The codes of each field evenly over its range, in an order drawn for each: spread_population().
struct SpreadStart {
    static constexpr std::string_view name = "spread",
                                      about = "the codes of each field evenly over its range, in an order drawn for "
                                              "each",
                                      source = "thesis 6.3, predefined populations; M. McKay et al., 1979";
    static constexpr std::tuple<> numbers() { return {}; }
};

/// Where a search begins, unless with the strings of a file.
class InitialPopulation : public OneOf<RandomStart, SpreadStart> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "initial-population",
                                      about = "where a search begins: at random, spread, or with strings of a file";
    static InitialPopulation named(std::string_view text) { return read<InitialPopulation>(text); }
};

} // namespace placedpar
