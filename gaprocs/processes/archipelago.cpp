#include "gaprocs/processes/archipelago.hpp"

#include "netlist/network/names.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <variant>

namespace placedpar {

namespace {

const std::string& text_of(const ProcessInstance& process, const char* parameter) {
    return std::get<std::string>(process.parameters.at(parameter));
}

/// As the topology orders them, where it has the same; else as they are connected.
std::vector<std::size_t> ordered(const std::vector<std::size_t>& connected, const Topology& topology,
                                 std::size_t island, std::size_t islands) {
    if (topology.is_given())
        return connected;
    try {
        auto named = topology.neighbours(islands)[island];
        if (std::ranges::is_permutation(named, connected))
            return named;
    } catch (const UserError&) { // it does not fit; the check of the netlist says so
    }
    return connected;
}

} // namespace

Archipelago::Archipelago(const Network& network) {
    for (std::size_t i = 0; i < network.processes.size(); ++i)
        if (network.processes[i].kind == "ga.island") {
            numbers_[i] = islands_.size();
            islands_.push_back({i, {}, {}, {}, {}});
        }
    for (std::size_t i = 0; i < islands_.size(); ++i)
        add_neighbours(network, i);
}

std::size_t Archipelago::number_of(std::size_t process) const { return numbers_.at(process); }

/// Process::ports lists the ends of an array in the order of their subscripts.
void Archipelago::add_neighbours(const Network& network, std::size_t island) {
    PlacedIsland& self = islands_[island];
    const ProcessInstance& process = network.processes[self.process];
    for (const PortBinding& binding : process.ports)
        if (base_name(binding.port) == "to_neighbours" || base_name(binding.port) == "from_neighbours")
            add_neighbour(network, self, binding);
    Topology topology = Topology::named(text_of(process, "topology"));
    self.neighbours = ordered(self.neighbours, topology, island, islands_.size());
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

Neighbours Archipelago::neighbours() const {
    Neighbours all;
    std::ranges::transform(islands_, std::back_inserter(all), &PlacedIsland::neighbours);
    return all;
}

std::vector<std::size_t> Archipelago::part_of(std::size_t island) const {
    for (auto& part : separate_parts(neighbours()))
        if (std::ranges::find(part, island) != part.end())
            return part;
    return {};
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
