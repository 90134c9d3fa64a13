#pragma once

#include "hydraulics/data/link.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::hydraulics {

/// The five configurations of the main valve. In each, the surplus oil of the two pumps takes another path to the four
/// links. This project has only the caption of Figure 2.11 and not its drawing. The five configurations are therefore
/// this project's interpretation.
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

/// A junction of the main valve, where oil divides. Oil arrives from pumps and from the bypasses of other junctions. It
/// leaves through the inlet orifice of one link and through the bypass around this link.
struct Junction {
    Link link;
    int pumps; ///< 0 to 2 pumps, each of constant flow
    Through through;
    /// The index of the junction to which the bypass leads, if any. INVARIANT: higher than this junction's index.
    std::size_t next = 0;
    Side side = Side::inlet; ///< the side of the link's cylinder that the junction feeds
};

/// Junctions between which oil flows, upstream before downstream.
using Circuit = std::vector<Junction>;

/// Returns the coupled groups of a configuration, ordered by their first link. A coupled group is a set of links of
/// which one can receive the oil that another does not take. The flow into each link then depends on all of them. A
/// search must therefore find the compliances of all active links of a group together.
std::vector<LinkSet> coupled_groups(Configuration);

/// Returns the circuit of the active links of one coupled group. A link at rest is left out, because its inlet is shut
/// and its bypass is wide open. REQUIRES: `active` is a non-empty subset of one coupled group.
Circuit circuit_of(Configuration, LinkSet active);
/// Returns the circuit in which only the boom moves, in configuration a.
Circuit boom_circuit();
/// Returns the drain side of a link as a circuit, so that equation 3.4 can be solved like the equations of the inlet
/// sides. The circuit is one junction without a pump, at the pressure of the cylinder. The piston pushes oil into the
/// junction. The outlet orifice takes the place of the bypass to the tank.
Circuit drain_circuit(Link);

/// Returns the thesis's name of the compliance at a junction: "C_BOi" on the inlet side, "C_BOo" on the outlet side.
std::string compliance_name(const Junction&);

} // namespace placedpar::hydraulics
