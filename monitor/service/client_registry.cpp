#include "monitor/service/client_registry.hpp"

#include <algorithm>
#include <utility>

namespace placedpar::monitor {

void ClientRegistry::enter(Client& client) { clients_.insert(&client); }

void ClientRegistry::leave(Client& client) {
    clients_.erase(&client);
    if (!client.hello)
        return;
    const std::string& machine = client.hello->machine;
    of_machine_[machine].erase(&client);
    if (of_machine_[machine].empty())
        of_machine_.erase(machine);
    if (control_of(machine) == &client)
        control_.erase(machine);
}

Client* ClientRegistry::join(Client& client) {
    of_machine_[client.hello->machine].insert(&client);
    if (client.hello->role != Role::control)
        return nullptr;
    return std::exchange(control_[client.hello->machine], &client);
}

const std::set<Client*>& ClientRegistry::of(const std::string& machine) const {
    static const std::set<Client*> no_clients;
    auto found = of_machine_.find(machine);
    return found == of_machine_.end() ? no_clients : found->second;
}

Client* ClientRegistry::control_of(const std::string& machine) const {
    auto found = control_.find(machine);
    return found == control_.end() ? nullptr : found->second;
}

namespace {

bool stays(const Client* client) { return !client->leaving && !client->finishing(); }

} // namespace

std::size_t ClientRegistry::staying(const std::string& machine) const {
    return static_cast<std::size_t>(std::ranges::count_if(of(machine), stays));
}

std::size_t ClientRegistry::size() const { return static_cast<std::size_t>(std::ranges::count_if(clients_, stays)); }

std::vector<Client*> ClientRegistry::those(const std::function<bool(const Client&)>& which) const {
    std::vector<Client*> found;
    std::ranges::copy_if(clients_, std::back_inserter(found),
                         [&](const Client* client) { return stays(client) && which(*client); });
    return found;
}

std::size_t ClientRegistry::queued_bytes() const {
    std::size_t bytes = 0;
    for (const Client* client : clients_)
        bytes += client->queued_bytes();
    return bytes;
}

} // namespace placedpar::monitor
