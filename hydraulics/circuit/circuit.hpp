#pragma once

#include "hydraulics/data/link.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::hydraulics {

/// The five configurations of the main valve. They differ in the flows that the check valves of the cross-over network
/// let through. We have only the text of Figure 2.11, not its drawing, so the five configurations are our
/// interpretation.
enum class Configuration : unsigned char { a, b, c, d, e };

inline constexpr std::array<Configuration, 5> all_configurations{Configuration::a, Configuration::b, Configuration::c,
                                                                 Configuration::d, Configuration::e};

char name_of(Configuration);
std::optional<Configuration> configuration_named(std::string_view);

/// The destination of the flow through a link's bypass orifice.
enum class Through : unsigned char {
    tank,
    junction, ///< the junction Junction::next
    nowhere   ///< a check valve blocks the flow
};

/// A junction of the main valve, from which the inlet orifice of one link and the bypass around this link branch off.
/// Flow arrives from pumps and from the bypasses that lead to this junction.
struct Junction {
    Link link;
    int pumps; ///< 0 to 2 pumps, each of constant flow
    Through through;
    /// The index of the junction to which the bypass leads, if any. INVARIANT: higher than this junction's index.
    std::size_t next = 0;
    Side side = Side::inlet; ///< the side of the link whose compliance is at this junction
};

/// Junctions that share flow, upstream before downstream.
using Circuit = std::vector<Junction>;

/// Returns the coupled groups of a configuration, ordered by their first link. Two links are in one coupled group if
/// oil that one link does not take can flow on to the other, so that the flow into each depends on both. A search for
/// the compliance of one link must therefore find the compliances of all active links of the group together.
std::vector<LinkSet> coupled_groups(Configuration);

/// Returns the circuit of the active links of one coupled group. An inactive link is left out: its spool rests, its
/// inlet is shut and its bypass is wide open. REQUIRES: `active` is a non-empty subset of one coupled group.
Circuit circuit_of(Configuration, LinkSet active);
Circuit boom_circuit();
/// Returns the drain side of a link as a circuit (equation 3.4): a junction without a pump, at the pressure of the
/// cylinder. The piston supplies the junction's flow, and the outlet orifice takes the place of the bypass to the tank.
Circuit drain_circuit(Link);

/// Returns the thesis's name of the compliance at a junction: "C_BOi" on the inlet side, "C_BOo" on the outlet side.
std::string compliance_name(const Junction&);

} // namespace placedpar::hydraulics
