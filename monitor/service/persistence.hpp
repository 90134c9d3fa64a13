#pragma once

#include "monitor/memory/alarm_board.hpp"
#include "monitor/memory/state_store.hpp"
#include "monitor/service/outbox.hpp"

#include <chrono>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::monitor {

/// Stores the accepted messages and their effects in the state file, and holds back the answers to clients until these
/// are on the disk. If storing fails, the diagnosis continues without storing, because the diagnosis is worth more than
/// its stored state.
class Persistence {
public:
    using Clock = std::chrono::steady_clock;

    /// If `store` is null, nothing is stored. `complain` receives messages for the operator.
    Persistence(StateStore* store, Outbox& outbox, std::function<void(const std::string&)> complain);

    /// Stores a message of the client that the machine's diagnosis has accepted.
    void record(Client& from, const std::string& machine, std::string_view line, std::size_t generations,
                std::vector<Entry> history);
    void save(const identification::Diagnosis& diagnosis);
    void forget(const std::string& machine);
    void change_history(Entry entry);

    /// Returns whether all accepted data is on the disk or being written. If the result is false, trouble() gives the
    /// reason.
    bool well() const { return trouble_.empty(); }
    const std::string& trouble() const { return trouble_; }

    /// Processes a report that the callback of StateStore::start() received. Returns whether well() has changed.
    bool note(const WriteProgress& progress);
    /// After a failure, tries to store everything again when the next attempt is due. Call this function a few times a
    /// second.
    void tick(const AlarmBoard& alarms);
    /// Stores all states, so that the next start has no messages to process, and closes the file. Throws UserError.
    void finish(const AlarmBoard& alarms);

private:
    StateStore* store_;
    Outbox& outbox_;
    std::function<void(const std::string&)> complain_;
    std::string trouble_;
    Clock::time_point next_attempt_{};
    std::chrono::seconds pause_{1}; ///< time to the next attempt
};

} // namespace placedpar::monitor
