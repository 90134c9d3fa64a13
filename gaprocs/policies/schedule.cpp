#include "gaprocs/policies/schedule.hpp"

#include <algorithm>
#include <numeric>

namespace placedpar {

namespace {

/// Returns the number of exchanges after which a sequential schedule of all islands repeats, at most 10 000.
std::uint64_t exchanges_of_a_round(const Neighbours& neighbours) {
    constexpr std::uint64_t most = 10'000;
    std::uint64_t round = 1;
    for (const auto& list : neighbours)
        round = std::min(most, std::lcm(round, std::max<std::uint64_t>(list.size(), 1)));
    return round;
}

/// Returns, for each island, how many islands send emigrants to the island after the given generation.
std::vector<std::size_t> senders(const Schedule& schedule, const Neighbours& neighbours, std::uint64_t generation) {
    std::vector<std::size_t> count(neighbours.size());
    for (const auto& list : neighbours)
        for (std::size_t to : schedule.destinations(generation, list))
            ++count[to];
    return count;
}

} // namespace

std::span<const std::size_t> BroadcastSchedule::operator()(std::uint64_t,
                                                           std::span<const std::size_t> neighbours) const {
    return neighbours;
}

std::span<const std::size_t> SequentialSchedule::operator()(std::uint64_t exchange,
                                                            std::span<const std::size_t> neighbours) const {
    return neighbours.empty() ? neighbours : neighbours.subspan((exchange - 1) % neighbours.size(), 1);
}

std::span<const std::size_t> AsynchronousSchedule::operator()(std::uint64_t,
                                                              std::span<const std::size_t> neighbours) const {
    return neighbours;
}

std::span<const std::size_t> OwnSchedule::operator()(std::uint64_t exchange,
                                                     std::span<const std::size_t> neighbours) const {
    return tried([&] {
        std::span<const std::size_t> chosen = choose_(exchange, neighbours);
        const std::size_t *begin = neighbours.data(), *end = begin + neighbours.size();
        require(chosen.empty() ||
                    (!std::less<>()(chosen.data(), begin) && !std::less<>()(end, chosen.data() + chosen.size())),
                "it must return a contiguous part of the given list of neighbours");
        return chosen;
    });
}

std::span<const std::size_t> Schedule::destinations(std::uint64_t generation,
                                                    std::span<const std::size_t> neighbours) const {
    if (!is_due(generation))
        return {};
    return std::visit([&](const auto& way) { return way(generation / way.every, neighbours); }, policy());
}

std::vector<std::size_t> most_senders_at_once(const Schedule& schedule, const Neighbours& neighbours) {
    if (schedule.is_own())
        return most_senders_at_once(BroadcastSchedule{}, neighbours);
    std::vector<std::size_t> most(neighbours.size());
    std::uint64_t round = schedule.takes_turns() ? exchanges_of_a_round(neighbours) : 1;
    for (std::uint64_t exchange = 1; exchange <= round; ++exchange) {
        auto now = senders(schedule, neighbours, exchange * schedule.every());
        std::ranges::transform(most, now, most.begin(), [](std::size_t a, std::size_t b) { return std::max(a, b); });
    }
    return most;
}

} // namespace placedpar
