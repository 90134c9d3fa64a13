#include "observe/trace/tracks.hpp"

#include "netlist/kinds/own_code.hpp"
#include "runtime/executive.hpp"
#include "runtime/trace.hpp"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <utility>

namespace placedpar {

namespace {

std::size_t found_in(const std::unordered_map<std::string, std::size_t>& tracks, const std::string& name) {
    auto found = tracks.find(name);
    return found == tracks.end() ? Tracks::none : found->second;
}

} // namespace

Tracks::Tracks(const Network& network) {
    for (std::size_t i = 0; i < network.nodes.size(); ++i) {
        const Node& node = network.nodes[i];
        nodes_.push_back(node.name + (node.type.empty() ? "" : " " + node.type));
        if (executes_in_time(network, i))
            add(network.nodes[i].name, {i, Track::Kind::processor, 0, {}});
    }
    for (std::size_t i = 0; i < network.processes.size(); ++i)
        add(network.processes[i].name, {network.processes[i].node, Track::Kind::process, i, {}});
    for (std::size_t i = 0, wires = network.count_wires(); i < wires; ++i)
        add_links(network, i);
    for (std::size_t i = 0; i < network.nodes.size(); ++i)
        add_tracks_of(network, i);
    number_as_drawn();
}

void Tracks::add_links(const Network& network, std::size_t index) {
    const LinkConnection& connection = network.connections[index];
    std::string a = link_name(network.nodes, connection.a), b = link_name(network.nodes, connection.b);
    add(a + " -> " + b, {connection.a.node, Track::Kind::link, index, {}});
    add(b + " -> " + a, {connection.b.node, Track::Kind::link, index, {1}});
}

void Tracks::add_tracks_of(const Network& network, std::size_t node) {
    const auto& tracks = network.nodes[node].kind->tracks;
    if (!tracks)
        return;
    std::size_t number = 0;
    for (std::string& name : ask_device(network.nodes[node], [&] { return tracks(network, node); }))
        add(std::move(name), {node, Track::Kind::bus, number++, {}});
}

void Tracks::number_as_drawn() {
    std::ranges::sort(tracks_, {}, &Track::place);
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
        tracks_[i].outermost = i;
        (tracks_[i].place.kind == Track::Kind::process ? processes_ : places_)[tracks_[i].name] = i;
    }
}

std::size_t Tracks::add(std::string name, Track::DrawingOrder place) {
    tracks_.push_back({std::move(name), std::move(place), tracks_.size()});
    return tracks_.size() - 1;
}

std::vector<std::size_t> Tracks::drawn() const {
    std::vector<std::size_t> numbers(tracks_.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    std::ranges::sort(numbers, {},
                      [this](std::size_t track) -> const Track::DrawingOrder& { return tracks_[track].place; });
    return numbers;
}

std::size_t Tracks::of(const Process& process) {
    std::string path = process.path();
    if (std::size_t track = found_in(processes_, path); track != none)
        return track;
    if (process.parent())
        add_component(process, path);
    else if (!add_machine_process(process, path))
        return none;
    return processes_[path];
}

std::size_t Tracks::of(const ProgramTurn& turn) { return of_program(turn.process, turn.place); }

/// Returns the track of a process of a booted program. "root.phil[2]/0" is a component of "root.phil[2]".
std::size_t Tracks::of_program(const std::string& process, const std::string& processor) {
    if (std::size_t track = found_in(processes_, process); track != none)
        return track;
    const std::size_t place = of_place(processor), slash = process.rfind('/');
    if (place == none)
        return none;
    if (slash == std::string::npos)
        return processes_[process] =
                   add(process, {tracks_[place].place.node, Track::Kind::program, tracks_.size(), {}});
    const std::size_t parent = of_program(process.substr(0, slash), processor);
    Track::DrawingOrder order = tracks_[parent].place;
    order.components.push_back(tracks_.size());
    const std::size_t track = processes_[process] = add(process, std::move(order));
    tracks_[track].outermost = tracks_[parent].outermost;
    return track;
}

/// Adds the track of a component, which is drawn below the track of its parent.
void Tracks::add_component(const Process& process, const std::string& path) {
    std::size_t parent = of(*process.parent());
    if (parent == none)
        return void(processes_[path] = none);
    Track::DrawingOrder place = tracks_[parent].place;
    std::size_t component = 0;
    std::from_chars(path.data() + path.rfind('/') + 1, path.data() + path.size(), component);
    place.components.push_back(component);
    processes_[path] = add(path, std::move(place));
    tracks_.back().outermost = tracks_[parent].outermost;
}

/// Adds the track of a process of the machine. Returns false if no node executes the process: it then takes no time and
/// has no track.
bool Tracks::add_machine_process(const Process& process, const std::string& path) {
    std::size_t processor = process.executive() ? of_place(process.executive()->name()) : none;
    if (processor == none)
        return false;
    std::size_t node = tracks_[processor].place.node;
    processes_[path] = add(path, {node, Track::Kind::machine_process, tracks_.size(), {}});
    return true;
}

std::size_t Tracks::of_place(const std::string& name) const { return found_in(places_, name); }

} // namespace placedpar
