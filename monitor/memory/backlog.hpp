#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace placedpar::monitor {

/// The messages that are in no machine's state yet, and would have to be taken again after a restart.
class Backlog {
public:
    /// REQUIRES: numbers go up.
    void add(const std::string& machine, std::uint64_t number, std::size_t bytes, std::size_t generations);
    /// Its state is kept, or nobody needs it any more.
    void drop(const std::string& machine);
    void clear();

    std::size_t bytes() const { return bytes_; }
    std::uint64_t generations() const { return generations_; }
    bool empty() const { return by_age_.empty(); }
    /// REQUIRES: it is not empty.
    std::uint64_t oldest_number() const { return by_age_.begin()->first; }
    /// Whose message that is.
    const std::string& oldest_machine() const { return by_age_.begin()->second; }

private:
    struct Share {
        std::uint64_t first;
        std::size_t bytes = 0;
        std::uint64_t generations = 0;
    };

    std::map<std::string, Share> shares_;
    std::map<std::uint64_t, std::string> by_age_; ///< machines by their first number
    std::size_t bytes_ = 0;
    std::uint64_t generations_ = 0;
};

} // namespace placedpar::monitor
