#include "gaprocs/processes/archipelago.hpp"

#include "gaprocs/processes/parameters.hpp"
#include "netlist/network/names.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <mutex>
#include <utility>
#include <variant>

namespace placedpar {

namespace {

const std::string& text_of(const ProcessInstance& process, const char* parameter) {
    return std::get<std::string>(process.parameters.at(parameter));
}

} // namespace

Archipelago::Archipelago(const Network& network) {
    for (std::size_t i = 0; i < network.processes.size(); ++i)
        if (network.processes[i].kind == "ga.island") {
            numbers_[i] = islands_.size();
            islands_.push_back({i, {}, {}, {}, {}, 0});
        }
    for (PlacedIsland& each : islands_)
        add_neighbours(network, each);
    for (std::size_t i = 0; i < islands_.size(); ++i)
        order_neighbours(text_of(network.processes[islands_[i].process], "topology"), i);
    std::ranges::transform(islands_, std::back_inserter(neighbours_), &PlacedIsland::neighbours);
    add_parts(network);
}

std::size_t Archipelago::number_of(std::size_t process) const { return numbers_.at(process); }

/// Adds the neighbours in the order of the ports' subscripts. ProcessInstance::ports lists the ends of an array in this
/// order.
void Archipelago::add_neighbours(const Network& network, PlacedIsland& self) {
    for (const PortBinding& binding : network.processes[self.process].ports)
        if (base_name(binding.port) == "to_neighbours" || base_name(binding.port) == "from_neighbours")
            add_neighbour(network, self, binding);
}

void Archipelago::add_neighbour(const Network& network, PlacedIsland& self, const PortBinding& binding) {
    bool to = binding.direction == Direction::output;
    const NetworkChannel& channel = network.channels[binding.channel];
    const ChannelEnd& other = to ? channel.to : channel.from;
    auto number = numbers_.find(other.process);
    const std::string& name = network.processes[self.process].name;
    if (number == numbers_.end())
        self.refused[binding.port] = fmt::format("\"{}.{}\" is not connected to an island", name, binding.port);
    else if (other.process == self.process)
        self.refused[binding.port] = fmt::format("\"{}\" is its own neighbour, expected another island", name);
    else if (!(to ? self.ports_to : self.ports_from).emplace(number->second, binding.port).second)
        self.refused[binding.port] = fmt::format("\"{}\" is connected to \"{}\" twice, expected once", name,
                                                 network.processes[other.process].name);
    else if (to)
        self.neighbours.push_back(number->second);
}

/// Puts the island's neighbours in the order of the named topology `text`, if the topology gives the island exactly
/// these neighbours. Otherwise keeps the order of the connections.
void Archipelago::order_neighbours(const std::string& text, std::size_t island) {
    auto [known, is_new] = topologies_.try_emplace(text);
    NamedTopology& named = known->second;
    Topology topology = Topology::named(text);
    if (is_new && !topology.is_given())
        try {
            named.neighbours = topology.neighbours(islands_.size());
        } catch (const UserError& does_not_fit) { // check_islands() reports the error
            named.does_not_fit = does_not_fit.what();
        }
    std::vector<std::size_t>& connected = islands_[island].neighbours;
    if (!named.neighbours.empty() && std::ranges::is_permutation(named.neighbours[island], connected))
        connected = named.neighbours[island];
}

void Archipelago::add_parts(const Network& network) {
    parts_ = separate_parts(neighbours_);
    samples_needed_.resize(parts_.size());
    for (std::size_t part = 0; part < parts_.size(); ++part)
        for (std::size_t island : parts_[part]) {
            islands_[island].part = part;
            samples_needed_[part] =
                std::max(samples_needed_[part], samples_needed(network.processes[islands_[island].process]));
        }
}

/// A cache holds the archipelagos; the key is the address and the hash of the network. An entry is removed when no
/// island uses the archipelago any more. While an island uses the archipelago, the network exists, and no other network
/// can have its address.
std::shared_ptr<const Archipelago> archipelago_of(const Network& network) {
    static std::mutex one_at_a_time;
    static std::map<std::pair<const Network*, std::uint64_t>, std::weak_ptr<const Archipelago>> all;
    std::scoped_lock lock(one_at_a_time);
    std::erase_if(all, [](const auto& each) { return each.second.expired(); });
    auto& known = all[{&network, network.hash}];
    auto found = known.lock();
    if (!found)
        known = found = std::make_shared<const Archipelago>(network);
    return found;
}

Schedule schedule_of(const ProcessInstance& process) {
    const std::string& schedule = text_of(process, "schedule");
    if (says_how_often(schedule))
        return Schedule::named(schedule);
    return Schedule::named(
        fmt::format("{}({})", schedule, std::get<std::int64_t>(process.parameters.at("exchange_every"))));
}

bool says_how_often(const std::string& schedule) { return schedule.find('(') != schedule.npos; }

} // namespace placedpar
