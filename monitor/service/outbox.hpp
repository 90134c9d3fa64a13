#pragma once

#include "monitor/service/client.hpp"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>

namespace placedpar::monitor {

/// Holds back the lines to clients until the data that they report is on the disk. A client that has read an answer can
/// therefore rely on the stored data, even if the computer then fails. Each client receives its lines in the order of
/// send(). Held bytes count as waiting output of the client.
class Outbox {
public:
    /// Makes lines sent from now on wait for this ticket. A ticket is the number of a write to the state file.
    /// REQUIRES: the ticket is not less than any earlier ticket.
    void wait_for(std::uint64_t ticket) { promised_ = ticket; }
    /// Records that everything up to this ticket is on the disk or lost, and sends the lines that waited for this
    /// ticket or earlier tickets.
    void release(std::uint64_t ticket);

    void send(Client& to, std::string line);
    /// Sends everything that waits for the client, then closes the client.
    void finish(Client& client);
    /// Counts `bytes` of the client's input, which are on their way to the disk, as waiting output of the client. The
    /// client is then slowed down if the disk is slow. Sends nothing.
    void hold(Client& client, std::size_t bytes);
    /// Forgets the client. Call this function before the client is destroyed.
    void drop(const Client& client);

private:
    struct Item {
        std::uint64_t ticket;
        Client* client; ///< null if the client has gone
        std::string line;
        std::size_t held;
        bool last = false; ///< the client is closed after this item
    };

    bool waits() const { return promised_ > released_; }
    void push(Item item);

    std::deque<Item> items_;
    std::uint64_t promised_ = 0, released_ = 0;
};

} // namespace placedpar::monitor
