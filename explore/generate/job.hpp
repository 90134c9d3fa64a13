#pragma once

#include "explore/generate/topology.hpp"

#include <string>

namespace placedpar::generate {

/// The processes of a netlist and their placement on the array `t` of processors.
struct Job {
    bool has_host = false;  ///< whether there is a process `host`, which the netlist must place
    std::string about;      ///< a description, such as "Islands: one on every processor. ..."
    std::string vals;       ///< lines, each with a newline
    std::string statements; ///< lines, each with a newline
};

/// Places a master, and a slave on every other processor. Channels to slaves that are not neighbours of the master are
/// routed through other processors.
Job farm(const Topology&);
/// Places an island on every processor; islands on neighbouring processors exchange individuals.
Job islands(const Topology&);
/// In the topology `figure-e2`, places an island on the head of each chain, and its slaves along the chain.
Job islands_with_slaves();
/// Places a process of `kind` on every processor, and connects it with its neighbours by the port arrays named by
/// `output` and `input`.
Job processes_of(const std::string& kind, bool has_host, const std::string& output, const std::string& input,
                 const Topology&);

} // namespace placedpar::generate
