#pragma once

#include "netlist/elaborate/draft.hpp"
#include "netlist/kinds/catalogue.hpp"
#include "netlist/language/made_netlist.hpp"
#include "netlist/network/network.hpp"
#include "text/reporter.hpp"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace placedpar {

/// Makes a Network from a draft, that is, from the result of executing a netlist's statements. Follows wires through
/// switches, finds the kinds and parameters of processes, and finds the directions of channels and what carries them.
/// Reports errors; after an error the result must not be used.
Network complete(Draft draft, const Catalogue& catalogue, Reporter& reporter, const CompiledPrograms& compiled);

/// Holds the data that the parts of complete() share. The functions below are these parts; complete() itself shows
/// their order. Each comment begins with the file that defines the function.
struct Completion {
    Draft draft;
    const Catalogue& catalogue;
    Reporter& reporter;
    const CompiledPrograms& compiled;
    Network network; ///< the result, which begins with the draft's nodes; each part of complete() adds to it
    std::map<std::pair<std::size_t, int>, std::size_t>
        connection_at; ///< index in network.connections; key: node and link
    std::map<std::size_t, std::size_t>
        connection_named;                   ///< index in network.connections; key: index in draft.connections
    std::vector<const ProcessKind*> kinds;  ///< kind of each process; null if the catalogue lacks it
    std::vector<bool> kind_refused;         ///< for each process: whether an error about its kind has been reported
    std::vector<std::size_t> draft_channel; ///< draft index of each channel of the network
    std::vector<bool> wire_refused = {};    ///< for each node: whether one of its wires leads nowhere
    bool buses_refused = false; ///< the ways over buses were not computed, because an earlier error was reported

    /// Returns the node's first link that has no wire, such as "a.link[2]"; "" if all links have wires.
    std::string free_link(std::size_t node) const;
};

/// images.cpp: lets a netlist without a machine run. If all processes are in occam (ProcessKind::is_code) and none is
/// placed, adds a transputer, and places all processes on it.
void place_code(Completion& completion);
/// hosts.cpp: turns each edge on which processes are placed into a workstation.
void complete_hosts(Completion& completion);
/// wires.cpp: joins pieces of wire and crosspoints into connections between processors.
void complete_wires(Completion& completion);
/// buses.cpp: computes the ways over buses from the devices attached to the buses.
void complete_buses(Completion& completion);
/// processes.cpp: checks placements, finds kinds, and checks interfaces against kinds.
void complete_processes(Completion& completion);
/// booted.cpp: finds the nodes that execute machine code, and checks what boots them.
void complete_booted(Completion& completion);
/// parameters.cpp: evaluates all parameters of one process.
void complete_parameters(Completion& completion, std::size_t process);
/// channels.cpp: finds directions; checks protocols and unconnected ports.
void complete_channels(Completion& completion);
/// carriers.cpp: chooses what carries each channel: memory, a link, a route over several links, or a bus.
void complete_carriers(Completion& completion);
/// switched.cpp: refuses channels that share a link in a forbidden way, if a switch connects this link during the run.
/// REQUIRES: all channels have their placements.
void check_switched(Completion& completion);
/// faults.cpp: finds the wires of links that fail.
void complete_faults(Completion& completion);
/// checks.cpp: calls the function `check` of each kind, which finds errors that only this kind knows. REQUIRES: nothing
/// was refused.
void complete_checks(Completion& completion);
/// booted.cpp: checks that the node can execute machine code. `reason` has notes, for a message, that tell why it must.
void check_executes(Completion& completion, const Node& node, const std::vector<SecondPlace>& reason);
/// images.cpp: marks the nodes with processes in occam, and checks these nodes. Called by complete_booted().
void mark_code_nodes(Completion& completion);
/// images.cpp: returns for each node whether channels between processes in occam may lead through it. Such a node can
/// execute machine code, is not booted with a file, and has no processes in C++.
std::vector<bool> nodes_for_code(const Completion& completion);
/// images.cpp: marks the nodes through which channels between processes in occam lead. These nodes then execute a
/// program that passes on the messages.
void complete_relays(Completion& completion);
/// images.cpp: compiles the image of each node with processes in occam: the program in its memory when the run begins.
/// REQUIRES: nothing was refused.
void complete_images(Completion& completion);

} // namespace placedpar
