#pragma once

#include "netlist/network/network.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// Prints a constant in the netlist language; the text reads back to the same value.
std::string print_constant(const Value& value);

/// Returns "name = value".
std::string print_entry(std::string_view name, const Value& value);

/// Returns the attributes that differ from those of the first element of the node's array, or from the kind's defaults
/// if `first` is null; after these, the attributes that only icconf uses.
std::vector<std::string> print_attributes(const Node& node, const Node* first = nullptr);

/// Describes consecutive elements of one array, or a single thing.
struct ElementRange {
    std::string declarator; ///< "t[4][4]"
    std::string base;       ///< "t"
    std::size_t first = 0, count = 0;
};

/// Groups names into arrays. REQUIRES: the names of an array are in the order of its elements.
std::vector<ElementRange> element_ranges(std::size_t count, const std::function<std::string_view(std::size_t)>& name);

/// Returns the declarators, in order of first appearance, that declare all these names: "c[3]" for c[0] and c[2].
std::vector<std::string> declarators_of(const std::vector<std::string>& names);

/// Returns "(a = 1, b = 2)", with a line break after each entry if the list is long; "" for an empty list.
std::string print_list(const std::vector<std::string>& entries);

/// Returns whether a wire leads to a transputer that executes its own code.
bool is_used_by_code(const Network& network, const LinkConnection& wire);

/// Says where a transputer gets its own code from: "boots hello.btl", "boots over its links".
std::string print_boot(const Node& node);

} // namespace placedpar
