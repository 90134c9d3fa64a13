#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace placedpar::monitor {

/// Counts the messages of machines (excavators under diagnosis) that are not yet part of a saved state. After a restart
/// the service must process these messages again. If they are too many, the service saves the states of some machines.
class Backlog {
public:
    /// REQUIRES: `number` is greater than in any earlier call.
    void add(const std::string& machine, std::uint64_t number, std::size_t bytes, std::size_t generations);
    /// Removes the messages of a machine, because its state was saved or the machine was forgotten.
    void drop(const std::string& machine);
    void clear();

    std::size_t bytes() const { return bytes_; }
    std::uint64_t generations() const { return generations_; }
    bool empty() const { return by_age_.empty(); }
    /// REQUIRES: the backlog is not empty.
    std::uint64_t oldest_number() const { return by_age_.begin()->first; }
    const std::string& oldest_machine() const { return by_age_.begin()->second; }

private:
    struct Share {
        std::uint64_t first;
        std::size_t bytes = 0;
        std::uint64_t generations = 0;
    };

    std::map<std::string, Share> shares_;
    std::map<std::uint64_t, std::string> by_age_; ///< key: number of the oldest counted message of the machine
    std::size_t bytes_ = 0;
    std::uint64_t generations_ = 0;
};

} // namespace placedpar::monitor
