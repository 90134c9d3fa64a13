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

/// Has what happens kept, where there is a state file, and what is said wait for it. When something cannot be kept, the
/// diagnosis goes on: it is worth more than its memory.
class Persistence {
public:
    using Clock = std::chrono::steady_clock;

    /// `store` may be null: nothing is kept. `complain` is given sentences for the operator.
    Persistence(StateStore* store, Outbox& outbox, std::function<void(const std::string&)> complain);

    /// The client's message, which its machine has taken.
    void record(Client& from, const std::string& machine, std::string_view line, std::size_t generations,
                std::vector<Entry> history);
    void save(const identification::Diagnosis& diagnosis);
    void forget(const std::string& machine);
    void change_history(Entry entry);

    /// Is all kept that has been taken, or on its way to the disk? If not, why.
    bool well() const { return trouble_.empty(); }
    const std::string& trouble() const { return trouble_; }

    /// What StateStore::start() has told. True: well() has changed.
    bool note(const WriteProgress& progress);
    /// Tries again, when it is time to, to keep everything. To be called a few times a second.
    void tick(const AlarmBoard& alarms);
    /// Keeps everything, so that the next start has nothing to do, and closes the file. Throws UserError.
    void finish(const AlarmBoard& alarms);

private:
    StateStore* store_;
    Outbox& outbox_;
    std::function<void(const std::string&)> complain_;
    std::string trouble_;
    Clock::time_point next_attempt_{};
    std::chrono::seconds pause_{1}; ///< to the next attempt
};

} // namespace placedpar::monitor
