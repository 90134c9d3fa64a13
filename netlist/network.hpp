#pragma once

#include "netlist/catalogue.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace placedpar {
struct Location { std::size_t file = 0; int line = 0, column = 0; };
enum class NodeKind { processor, workstation, edge, c004 };
struct Node { std::string name; std::string type; NodeKind kind; std::int64_t memory_bytes, clock_hz, link_bits_per_second, channel_call_cycles; Location declared; };
struct LinkEnd { std::size_t node; int link; };
struct LinkConnection { LinkEnd a, b; std::int64_t bits_per_second; double metres; int switches = 0; Location connected; std::string name; };
struct PortBinding { std::string port; Direction direction; std::size_t channel; };
struct ProcessInstance { std::string name; std::string kind; std::map<std::string, Value> parameters; bool high_priority; std::size_t node; std::vector<PortBinding> ports; Location declared; };
struct ChannelEnd { std::size_t process; std::string port; };
enum class CarrierKind { soft, link, edge };
struct NetworkCarrier { CarrierKind kind; std::size_t connection; bool from_a_to_b; bool shared; };
struct NetworkChannel { std::string name; ChannelEnd from, to; NetworkCarrier carrier; Location connected; };
struct Network { std::vector<Node> nodes; std::vector<LinkConnection> connections; std::vector<ProcessInstance> processes; std::vector<NetworkChannel> channels; std::string source_path; std::uint64_t hash = 0; };
} // namespace placedpar
