#pragma once

#include "monitor/service/client.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace placedpar::monitor {

/// Who is connected, and to which machine.
class ClientRegistry {
public:
    void enter(Client& client);
    void leave(Client& client);
    /// It has said hello: client.hello. Gives the control system that it takes the place of; null when there is none.
    Client* join(Client& client);

    const std::set<Client*>& all() const { return clients_; }
    /// Those that said hello for this machine.
    const std::set<Client*>& of(const std::string& machine) const;
    /// How many of those are not about to be closed.
    std::size_t staying(const std::string& machine) const;
    /// Null when there is none.
    Client* control_of(const std::string& machine) const;
    /// Without those that are about to be closed, as are these.
    std::size_t size() const;
    std::vector<Client*> those(const std::function<bool(const Client&)>& which) const;
    std::size_t queued_bytes() const;

private:
    std::set<Client*> clients_;
    std::map<std::string, std::set<Client*>> of_machine_;
    std::map<std::string, Client*> control_;
};

} // namespace placedpar::monitor
