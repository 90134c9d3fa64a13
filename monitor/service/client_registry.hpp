#pragma once

#include "monitor/service/client.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace placedpar::monitor {

/// Records the connected clients, and to which machine (excavator) each belongs.
class ClientRegistry {
public:
    void enter(Client& client);
    void leave(Client& client);
    /// Registers a client under its machine. REQUIRES: the client has sent hello, so that `client.hello` is set.
    /// Returns the client that was the machine's control system, if the new client replaces it, or null.
    Client* join(Client& client);

    const std::set<Client*>& all() const { return clients_; }
    /// Returns the clients that have said hello for this machine.
    const std::set<Client*>& of(const std::string& machine) const;
    /// Returns the number of the machine's clients without those that are about to be closed.
    std::size_t staying(const std::string& machine) const;
    /// Returns the machine's control system, or null.
    Client* control_of(const std::string& machine) const;
    /// Returns the number of clients. This function and those() leave out clients that are about to be closed.
    std::size_t size() const;
    std::vector<Client*> those(const std::function<bool(const Client&)>& which) const;
    std::size_t queued_bytes() const;

private:
    std::set<Client*> clients_;
    std::map<std::string, std::set<Client*>> of_machine_;
    std::map<std::string, Client*> control_;
};

} // namespace placedpar::monitor
