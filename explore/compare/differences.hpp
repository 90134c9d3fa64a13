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
    std::string name;                  ///< "clock"
    std::string a, b;                  ///< values as the netlist language writes them
    std::vector<std::string> elements; ///< elements that have these values in A and B; empty if the setting is a val
    Overrides set;                     ///< settings for A that give it the values of B
};

/// A part of the structure that only one of two networks has, such as "T800 t[4]" or "t[0].link[1] to t[1].link[2]".
struct StructureDifference {
    /// The part of a netlist that differs, which is a section of the text that print_cfs() writes.
    enum class Section { hardware, software, mapping, faults } section;
    std::vector<std::string> only_a, only_b;
};

const char* name_of(StructureDifference::Section);

/// Returns the differences in attributes of nodes and wires and in parameters of processes. Elements of both networks
/// are compared by name. Elements share one difference if their values in A are equal and their values in B are equal.
std::vector<SettingDifference> setting_differences(const Network& a, const Network& b);

/// Returns a difference for each section that differs.
std::vector<StructureDifference> structure_differences(const Network& a, const Network& b);

} // namespace placedpar
