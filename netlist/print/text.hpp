#pragma once

#include "netlist/network/network.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// A constant in the netlist language; reads back to the same value.
std::string print_constant(const Value& value);

/// Consecutive elements of one array, or a single thing.
struct ElementRange {
    std::string declarator; ///< "t[4][4]"
    std::string base;       ///< "t"
    std::size_t first = 0, count = 0;
};

/// Finds the arrays again among names in the order of their elements.
std::vector<ElementRange> element_ranges(std::size_t count, const std::function<std::string_view(std::size_t)>& name);

/// The declarators, in order of first appearance, that make all these names: "c[3]" for c[0] and c[2].
std::vector<std::string> declarators_of(const std::vector<std::string>& names);

/// "(a = 1, b = 2)" with a line break after each when it gets long; "" for none.
std::string print_list(const std::vector<std::string>& entries);

} // namespace placedpar
