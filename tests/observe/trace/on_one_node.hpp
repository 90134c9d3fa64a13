#pragma once

#include "netlist/kinds/device_kind.hpp"
#include "netlist/network/network.hpp"

#include <memory>
#include <string>
#include <vector>

namespace placedpar::test {

/// Returns a network with one node, "t", and these processes on the node.
inline Network on_one_node(const std::vector<std::string>& processes) {
    Network network;
    DeviceKind kind;
    kind.executes = Execution::in_time;
    Node node;
    node.name = "t";
    node.kind = std::make_shared<const DeviceKind>(kind);
    network.nodes.push_back(node);
    for (const std::string& name : processes) {
        ProcessInstance process;
        process.name = name;
        process.node = 0;
        network.processes.push_back(process);
    }
    return network;
}

} // namespace placedpar::test
