#pragma once

#include "hydraulics/data/link.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace placedpar::hydraulics {

/// The five configurations of the main valve, by what the check valves of its cross-over network let through
/// (Figure 2.11: we have its text without the drawing, and follow our interpretation of it).
enum class Configuration : unsigned char { a, b, c, d, e };

inline constexpr std::array<Configuration, 5> all_configurations{Configuration::a, Configuration::b, Configuration::c,
                                                                 Configuration::d, Configuration::e};

char name_of(Configuration);
std::optional<Configuration> configuration_named(std::string_view);

/// Where the flow through a link's bypass orifice goes.
enum class Through : unsigned char {
    tank,
    junction, ///< Junction::next
    nowhere   ///< a check valve keeps it shut
};

/// A junction of the main valve: the inlet orifice of one link and the bypass past it leave from here. Flow
/// comes from a pump, from the bypasses that lead here, or from both.
struct Junction {
    Link link;
    int pumps; ///< of constant flow each: 0 to 2
    Through through;
    std::size_t next = 0; ///< of the circuit's junctions, when the bypass leads to one; INVARIANT: a later one
};

/// Junctions that share flow, upstream before downstream.
using Circuit = std::vector<Junction>;

/// The links of a configuration that are coupled with each other hydraulically, in groups: a search for one
/// compliance must find the compliances of its whole group at once. Ordered by their first link.
std::vector<LinkSet> coupled_groups(Configuration);

/// The circuit of the active links of one group. An inactive link is left out: its spool rests, its inlet is
/// shut and its bypass wide open. REQUIRES: `active` is a non-empty part of one coupled group.
Circuit circuit_of(Configuration, LinkSet active);
/// The boom alone, fed by its pump.
Circuit boom_circuit();

} // namespace placedpar::hydraulics
