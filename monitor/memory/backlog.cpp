#include "monitor/memory/backlog.hpp"

namespace placedpar::monitor {

void Backlog::add(const std::string& machine, std::uint64_t number, std::size_t bytes, std::size_t generations) {
    auto [place, made] = shares_.try_emplace(machine, Share{number});
    if (made)
        by_age_[number] = machine;
    place->second.bytes += bytes;
    place->second.generations += generations;
    bytes_ += bytes;
    generations_ += generations;
}

void Backlog::drop(const std::string& machine) {
    auto found = shares_.find(machine);
    if (found == shares_.end())
        return;
    bytes_ -= found->second.bytes;
    generations_ -= found->second.generations;
    by_age_.erase(found->second.first);
    shares_.erase(found);
}

void Backlog::clear() { *this = {}; }

} // namespace placedpar::monitor
