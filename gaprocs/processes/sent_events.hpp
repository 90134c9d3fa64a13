#pragma once

#include "gaprocs/checkpoints.hpp"
#include "gaprocs/search_observer.hpp"
#include "runtime/byte_form.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>

namespace placedpar {

/// Sends the events of searches to rank 0 of a run that is divided among several computers (ranks). There tell_event()
/// passes the events to an observer.
class SentEvents final : public SearchObserver {
public:
    explicit SentEvents(std::function<void(MessageBytes)> send) : send_(std::move(send)) {}
    void observe(const ObservedGeneration&) override;
    void observe(const ObservedMigration&) override;
    void observe(const ObservedAnswer&) override;

private:
    std::function<void(MessageBytes)> send_;
};

/// Sends the states of searches to rank 0, where tell_event() stores them. The searches of this rank continue from
/// `begun`.
class SentCheckpoints final : public Checkpoints {
public:
    /// REQUIRES: `begun` outlives this object.
    SentCheckpoints(const Checkpoints& begun, std::function<void(MessageBytes)> send)
        : begun_(begun), send_(std::move(send)) {}
    const SearchCheckpoint* begin_of(const std::string& search) const override { return begun_.begin_of(search); }
    bool is_due(std::uint64_t generation) const override { return begun_.is_due(generation); }
    void keep(const std::string& search, const SearchCheckpoint&) override;

private:
    const Checkpoints& begun_;
    std::function<void(MessageBytes)> send_;
};

/// Unpacks a message of SentEvents or SentCheckpoints, and passes it to the observer or the checkpoints. Throws
/// NoMessage if the bytes are not such a message, and whatever the observer or the checkpoints throw. REQUIRES: the
/// observer is not null; the checkpoints are not null if other ranks send states.
void tell_event(std::span<const std::uint8_t> packed, SearchObserver*, Checkpoints*);

} // namespace placedpar
