#pragma once

#include "netlist/elaborate/overrides.hpp"
#include "netlist/network/network.hpp"

#include <map>
#include <string>
#include <vector>

namespace placedpar {

/// A setting that has one value in network A and another in network B: a constant (`val`) of the netlist, or an
/// attribute or a parameter of some elements.
struct SettingDifference {
    std::string name; ///< "clock"
    std::string a, b; ///< values as the netlist language writes them
    /// Nodes, wires or processes that have these values in A and B; empty if the setting is a constant.
    std::vector<std::string> elements;
    Overrides set; ///< settings for A that give it the values of B
};

/// A part of the structure that only one of two networks has, such as "T800 t[4]" or "t[0].link[1] to t[1].link[2]".
struct StructureDifference {
    /// The part of a netlist that differs, which is a section of the text that print_cfs() writes.
    enum class Section { hardware, software, mapping, faults } section;
    std::vector<std::string> only_a, only_b;
};

const char* name_of(StructureDifference::Section);

/// Returns the differences in attributes of nodes and wires and in parameters of processes. Elements (nodes, wires or
/// processes) of both networks are compared by name. Elements with equal values in A and equal values in B have one
/// common difference.
std::vector<SettingDifference> setting_differences(const Network& a, const Network& b);

/// Returns a difference for each section that differs.
std::vector<StructureDifference> structure_differences(const Network& a, const Network& b);

} // namespace placedpar
