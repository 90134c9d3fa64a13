#pragma once

#include "gaprocs/search_observer.hpp"
#include "runtime/byte_form.hpp"

#include <cstdint>
#include <functional>
#include <span>

namespace placedpar {

/// Packs the events of searches and sends them away, to where tell_event() passes them to another observer.
class SentEvents final : public SearchObserver {
public:
    explicit SentEvents(std::function<void(MessageBytes)> send) : send_(std::move(send)) {}
    void observe(const ObservedGeneration&) override;
    void observe(const ObservedMigration&) override;
    void observe(const ObservedAnswer&) override;

private:
    std::function<void(MessageBytes)> send_;
};

/// Passes an event that SentEvents has packed to an observer. Throws NoMessage.
void tell_event(std::span<const std::uint8_t> packed, SearchObserver&);

} // namespace placedpar
