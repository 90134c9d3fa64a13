#pragma once

#include "monitor/service/client.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

namespace placedpar::monitor {

/// What clients are told, held back until what it tells of is on the disk. Each client hears everything in the order in
/// which it was said. Bytes that are held back count as queued for the client.
class Outbox {
public:
    /// What is said from now on waits for this ticket, which is no less than any before.
    void wait_for(std::uint64_t ticket) { promised_ = ticket; }
    /// All up to this ticket is on the disk, or lost.
    void release(std::uint64_t ticket);

    void send(Client& to, std::string line);
    /// After what it has been sent.
    void finish(Client& client);
    /// So many bytes, on their way to the disk, are the client's; nothing is said.
    void hold(Client& client, std::size_t bytes);
    /// REQUIRES: before the client goes.
    void drop(const Client& client);

private:
    struct Item {
        std::uint64_t ticket;
        Client* client; ///< null: it has gone
        std::string line;
        std::size_t held;
        bool last = false; ///< the client is to be closed then
    };

    bool waits() const { return promised_ > released_; }
    void push(Item item);

    std::deque<Item> items_;
    std::uint64_t promised_ = 0, released_ = 0;
};

} // namespace placedpar::monitor
