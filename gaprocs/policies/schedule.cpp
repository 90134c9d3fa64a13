#include "gaprocs/policies/schedule.hpp"

#include <variant>

namespace placedpar {

std::span<const std::size_t> BroadcastSchedule::operator()(std::uint64_t,
                                                           std::span<const std::size_t> neighbours) const {
    return neighbours;
}

std::span<const std::size_t> SequentialSchedule::operator()(std::uint64_t exchange,
                                                            std::span<const std::size_t> neighbours) const {
    return neighbours.empty() ? neighbours : neighbours.subspan((exchange - 1) % neighbours.size(), 1);
}

std::span<const std::size_t> Schedule::destinations(std::uint64_t generation,
                                                    std::span<const std::size_t> neighbours) const {
    auto of_way = [&](const auto& way) {
        bool due = generation > 0 && generation % way.every == 0;
        return due ? way(generation / way.every, neighbours) : std::span<const std::size_t>();
    };
    return std::visit(of_way, policy());
}

} // namespace placedpar
