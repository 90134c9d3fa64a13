#pragma once

#include "netlist/network/network.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// Prints a constant in the netlist language, so that reading the text gives the same value.
std::string print_constant(const Value& value);

/// Returns "name = value".
std::string print_entry(std::string_view name, const Value& value);

/// Returns the attributes in which the node differs from `first`, the first element of its array. If `first` is null,
/// returns the attributes that differ from the defaults of the node's kind. Attributes that only INMOS's configurer
/// icconf uses follow.
std::vector<std::string> print_attributes(const Node& node, const Node* first = nullptr);

/// Describes consecutive elements of one array, or a single node, connection or process.
struct ElementRange {
    std::string declarator; ///< "t[4][4]"
    std::string base;       ///< "t"
    std::size_t first = 0, count = 0;
};

/// Groups names into arrays: "t[0]" and "t[1]" into "t[2]". `name` returns a name by its index, from 0 to `count` - 1.
/// REQUIRES: the names of an array are in the order of its elements.
std::vector<ElementRange> element_ranges(std::size_t count, const std::function<std::string_view(std::size_t)>& name);

/// Returns the declarators that declare all these names, such as "c[3]" for c[0] and c[2]. They are in the order in
/// which the names first appear.
std::vector<std::string> declarators_of(const std::vector<std::string>& names);

/// Returns "(a = 1, b = 2)", with a line break after each entry if the list is long; "" for an empty list.
std::string print_list(const std::vector<std::string>& entries);

/// Returns whether a wire leads to a transputer whose machine code is executed, so that the code may use the wire.
bool is_used_by_code(const Network& network, const LinkConnection& wire);

/// Returns the attributes that drawings show after the node's type: ", 2 MB, 20 MHz".
std::string print_drawn_facts(const Node& node);

/// Returns a text about how a transputer receives its own code: "boots hello.btl" or "boots over its links".
std::string print_boot(const Node& node);

} // namespace placedpar
