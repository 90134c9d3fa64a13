#include "native/placement.hpp"

#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

namespace placedpar::native {

namespace {

std::vector<bool> nodes_with_processes(const Network& network) {
    std::vector<bool> has_process(network.nodes.size());
    for (const ProcessInstance& process : network.processes)
        has_process[process.node] = true;
    return has_process;
}

/// Returns the node's attribute `rank`, if it has one. Throws UserError if the run has no such thread or rank.
std::optional<std::size_t> rank_on(const Places& places, const Node& node) {
    const std::optional<std::size_t> rank = node.rank;
    if (rank >= places.count)
        throw UserError(fmt::format("{}: \"{}\" has rank = {}, but the run has {}, counted from 0: {}",
                                    node.declared.text(), node.name, *rank, counted(places.count, places.noun),
                                    *rank < places.most ? fmt::format("give {} {} or more", places.how, *rank + 1)
                                                        : fmt::format("give a rank below {}", places.most)));
    return rank;
}

std::vector<std::size_t> place_in_turn(const Network& network, const Places& places) {
    const std::vector<bool> has_process = nodes_with_processes(network);
    std::vector<std::size_t> result(network.nodes.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < result.size(); ++i)
        if (has_process[i])
            result[i] = rank_on(places, network.nodes[i]).value_or(next++ % places.count);
    return result;
}

/// Assigns nodes (processors of the netlist) one after another to the place with the least load.
class Balance {
public:
    explicit Balance(std::size_t places) : filled_(places) {}

    void add(std::size_t place, Time load) {
        filled_[place].load += load;
        ++filled_[place].nodes;
    }
    std::size_t lightest() const {
        const auto key = [](const Filled& each) { return std::tuple(each.load, each.nodes); };
        return static_cast<std::size_t>(std::ranges::min_element(filled_, {}, key) - filled_.begin());
    }

private:
    struct Filled {
        Time load{};
        std::size_t nodes = 0;
    };
    std::vector<Filled> filled_;
};

std::vector<std::size_t> place_by_load(const Network& network, const Places& places, const std::vector<Time>& loads) {
    const std::vector<bool> has_process = nodes_with_processes(network);
    std::vector<std::size_t> result(network.nodes.size()), free;
    Balance balance(places.count);
    for (std::size_t i = 0; i < result.size(); ++i)
        if (!has_process[i])
            continue;
        else if (const std::optional<std::size_t> rank = rank_on(places, network.nodes[i]))
            balance.add(result[i] = *rank, loads[i]);
        else
            free.push_back(i);
    std::ranges::stable_sort(free, std::ranges::greater{}, [&](std::size_t node) { return loads[node]; });
    for (const std::size_t node : free)
        balance.add(result[node] = balance.lightest(), loads[node]);
    return result;
}

} // namespace

std::size_t most_places(const Network& network) {
    const std::vector<bool> has_process = nodes_with_processes(network);
    std::size_t most = static_cast<std::size_t>(std::ranges::count(has_process, true));
    for (std::size_t i = 0; i < has_process.size(); ++i)
        if (const std::optional<std::size_t> rank = network.nodes[i].rank; rank && has_process[i])
            most = std::max(most, *rank + 1);
    return most;
}

void require_enough_nodes(const Network& network, std::size_t ranks) {
    const std::size_t most = most_places(network);
    if (ranks <= most)
        return;
    if (most == 0)
        throw UserError(
            fmt::format("{}: no processor has a process, so {} ranks have nothing to share: run the netlist "
                        "without mpirun, or predict it without --ranks",
                        network.source_path, ranks));
    throw UserError(fmt::format("{}: there are {} ranks, but only {} processes: start at most {}", network.source_path,
                                ranks, counted(most, "processor has", "processors have"), counted(most, "rank")));
}

std::vector<std::size_t> place_nodes(const Network& network, const Places& places, const std::vector<Time>& loads) {
    return loads.empty() ? place_in_turn(network, places) : place_by_load(network, places, loads);
}

} // namespace placedpar::native
