#include "monitor/service/outbox.hpp"

#include <utility>

namespace placedpar::monitor {

void Outbox::push(Item item) {
    item.client->hold(static_cast<std::ptrdiff_t>(item.held));
    items_.push_back(std::move(item));
}

void Outbox::send(Client& to, std::string line) {
    std::size_t size = line.size();
    if (waits())
        push({promised_, &to, std::move(line), size});
    else
        to.send(line);
}

void Outbox::finish(Client& client) {
    client.leaving = true;
    if (waits())
        push({promised_, &client, "", 0, true});
    else
        client.finish();
}

void Outbox::hold(Client& client, std::size_t bytes) {
    if (waits())
        push({promised_, &client, "", bytes});
}

void Outbox::release(std::uint64_t ticket) {
    released_ = ticket;
    while (!items_.empty() && items_.front().ticket <= ticket) {
        Item item = std::move(items_.front());
        items_.pop_front();
        if (!item.client)
            continue;
        item.client->hold(-static_cast<std::ptrdiff_t>(item.held));
        if (!item.line.empty())
            item.client->send(item.line);
        if (item.last)
            item.client->finish();
    }
}

void Outbox::drop(const Client& client) {
    for (Item& item : items_)
        if (item.client == &client)
            item.client = nullptr;
}

} // namespace placedpar::monitor
