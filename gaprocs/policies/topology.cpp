#include "gaprocs/policies/topology.hpp"

#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <utility>
#include <variant>

namespace placedpar {

namespace {

/// The list of an island's neighbours during its construction.
class NeighbourList {
public:
    explicit NeighbourList(std::size_t island) : island_(island) {}
    void add(std::size_t other) {
        if (other != island_ && std::find(others_.begin(), others_.end(), other) == others_.end())
            others_.push_back(other);
    }
    const std::vector<std::size_t>& others() const { return others_; }

private:
    std::size_t island_;
    std::vector<std::size_t> others_;
};

/// Returns the neighbours of all islands. add_neighbours(i, list) adds the neighbours of island i to the list.
template <class Add>
Neighbours neighbours_by(std::size_t islands, Add add_neighbours) {
    Neighbours all;
    for (std::size_t i = 0; i < islands; ++i) {
        NeighbourList list(i);
        add_neighbours(i, list);
        all.push_back(list.others());
    }
    return all;
}

void require_given_neighbour(const Neighbours& neighbours, std::size_t island, std::size_t other) {
    if (other >= neighbours.size())
        throw UserError(fmt::format("island {} has island {} as neighbour, expected 0 to {}", island, other,
                                    neighbours.size() - 1));
    if (other == island)
        throw UserError(fmt::format("island {} is its own neighbour, expected another island", island));
    const auto& list = neighbours[island];
    if (std::count(list.begin(), list.end(), other) > 1)
        throw UserError(fmt::format("island {} has island {} as neighbour twice, expected once", island, other));
}

/// Returns, for each island, all islands that have the island as a neighbour.
Neighbours reversed(const Neighbours& neighbours) {
    Neighbours back(neighbours.size());
    for (std::size_t i = 0; i < neighbours.size(); ++i)
        for (std::size_t other : neighbours[i])
            back[other].push_back(i);
    return back;
}

/// Returns the neighbours that the islands would have if each connection led in both directions.
Neighbours both_ways(const Neighbours& neighbours) {
    Neighbours both = reversed(neighbours);
    for (std::size_t i = 0; i < neighbours.size(); ++i)
        both[i].insert(both[i].end(), neighbours[i].begin(), neighbours[i].end());
    return both;
}

void require_neighbours(const Neighbours& neighbours) {
    Neighbours both = both_ways(neighbours);
    auto alone = std::find_if(both.begin(), both.end(), [](const auto& list) { return list.empty(); });
    if (alone != both.end())
        throw UserError(fmt::format("island {} of {} has no neighbours, expected at least one, or the topology "
                                    "\"none\" for islands that exchange nothing",
                                    alone - both.begin(), both.size()));
}

std::vector<std::size_t> divisors(std::size_t number) {
    std::vector<std::size_t> all;
    for (std::size_t i = 1; i <= number; ++i)
        if (number % i == 0)
            all.push_back(i);
    return all;
}

} // namespace

Neighbours RingTopology::operator()(std::size_t islands) const {
    return neighbours_by(islands, [&](std::size_t i, NeighbourList& list) {
        list.add((i + 1) % islands);
        if (ways == 2)
            list.add((i + islands - 1) % islands);
    });
}

Neighbours HypercubeTopology::operator()(std::size_t islands) const {
    if (!std::has_single_bit(islands))
        throw UserError(fmt::format("a hypercube cannot have {} islands, expected a power of two such as {} or {}",
                                    islands, std::bit_floor(islands), std::bit_ceil(islands)));
    return neighbours_by(islands, [&](std::size_t i, NeighbourList& list) {
        for (std::size_t digit = 1; digit < islands; digit *= 2)
            list.add(i ^ digit);
    });
}

Neighbours TorusTopology::operator()(std::size_t islands) const {
    if (islands % rows != 0)
        throw UserError(fmt::format("a torus of {} cannot have {} rows, expected a divisor of {}: {}",
                                    counted(islands, "island"), rows, islands, fmt::join(divisors(islands), ", ")));
    std::size_t columns = islands / rows;
    return neighbours_by(islands, [&](std::size_t i, NeighbourList& list) {
        std::size_t row = i / columns, column = i % columns;
        list.add(row * columns + (column + 1) % columns);
        list.add((row + 1) % rows * columns + column);
        list.add(row * columns + (column + columns - 1) % columns);
        list.add((row + rows - 1) % rows * columns + column);
    });
}

Neighbours StarTopology::operator()(std::size_t islands) const {
    Neighbours all(islands, {0});
    all.front().clear();
    for (std::size_t i = 1; i < islands; ++i)
        all.front().push_back(i);
    return all;
}

Neighbours CompleteTopology::operator()(std::size_t islands) const {
    return neighbours_by(islands, [&](std::size_t i, NeighbourList& list) {
        for (std::size_t step = 1; step < islands; ++step)
            list.add((i + step) % islands);
    });
}

Neighbours GivenTopology::operator()(std::size_t islands) const {
    if (neighbours.size() != islands)
        throw UserError(fmt::format("the list has the neighbours of {}, but the number of islands is {}",
                                    counted(neighbours.size(), "island"), islands));
    for (std::size_t i = 0; i < islands; ++i)
        for (std::size_t other : neighbours[i])
            require_given_neighbour(neighbours, i, other);
    return neighbours;
}

Neighbours Topology::neighbours(std::size_t islands) const {
    if (islands == 0)
        throw UserError("the number of islands is 0, expected at least 1");
    Neighbours all = std::visit([&](const auto& way) { return way(islands); }, policy());
    if (exchanges())
        require_neighbours(all);
    return all;
}

std::vector<std::optional<std::size_t>> distances(const Neighbours& neighbours, std::size_t from) {
    std::vector<std::optional<std::size_t>> distance(neighbours.size());
    distance[from] = 0;
    std::vector<std::size_t> reached{from};
    for (std::size_t next = 0; next < reached.size(); ++next)
        for (std::size_t other : neighbours[reached[next]])
            if (!distance[other]) {
                distance[other] = *distance[reached[next]] + 1;
                reached.push_back(other);
            }
    return distance;
}

std::vector<std::vector<std::size_t>> separate_parts(const Neighbours& neighbours) {
    Neighbours both = both_ways(neighbours);
    std::vector<std::vector<std::size_t>> parts;
    std::vector<bool> known(both.size());
    for (std::size_t i = 0; i < both.size(); ++i) {
        if (known[i])
            continue;
        std::vector<std::size_t> part{i};
        known[i] = true;
        for (std::size_t next = 0; next < part.size(); ++next)
            for (std::size_t other : both[part[next]])
                if (!known[other]) {
                    known[other] = true;
                    part.push_back(other);
                }
        std::ranges::sort(part);
        parts.push_back(std::move(part));
    }
    return parts;
}

std::optional<OneWay> one_way(const Neighbours& neighbours) {
    Neighbours back = reversed(neighbours);
    for (const auto& part : separate_parts(neighbours)) {
        if (part.size() == 1)
            continue;
        auto reached = distances(neighbours, part.front()), reaching = distances(back, part.front());
        bool reaches_all = std::ranges::all_of(part, [&](std::size_t to) { return reached[to].has_value(); });
        auto from = std::ranges::find_if(part, [&](std::size_t each) { return !reaches_all || !reaching[each]; });
        if (from == part.end())
            continue; // the first island of this part reaches all others, and all others reach it
        auto distance = distances(neighbours, *from);
        return OneWay{*from, *std::ranges::find_if(part, [&](std::size_t to) { return !distance[to]; })};
    }
    return std::nullopt;
}

} // namespace placedpar
