#pragma once

#include "monitor/memory/backlog.hpp"
#include "monitor/memory/writer.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar::identification {
class Diagnosis; // identification/on_line/diagnosis.hpp
}

namespace placedpar::monitor {

class Diagnoses; // monitor/memory/diagnoses.hpp

/// Keeps all diagnoses across a restart. The state file holds a state of each machine and the messages that the machine
/// has accepted since. A diagnosis is a function of its messages, so processing them again restores it bit by bit.
///
/// 1. A separate thread writes the file. Each function that stores something returns a ticket. `tell` is called when
///    everything up to a ticket is on the disk or lost.
/// 2. After entries were lost, nothing is stored until write_anew() has stored all states again.
/// 3. All functions are called from one thread.
class StateStore {
public:
    /// Limits the backlog, since a restart must process its messages again. When the backlog is longer, the machines
    /// with the oldest messages are saved as states.
    static constexpr std::size_t most_backlog_bytes = 8u << 20;
    static constexpr std::uint64_t most_backlog_generations = 100000; ///< 1 to 5 s of work

    /// Opens the file and restores its content. Throws UserError, naming the file, if the file cannot be used.
    StateStore(const std::filesystem::path& path, Diagnoses& diagnoses, std::uint64_t most_history);
    ~StateStore();

    /// Returns why the file could not be written when it was opened, for example because the disk was full; "" if it
    /// could be written.
    const std::string& trouble() const { return trouble_; }
    /// Returns a message for the operator about opening the file; "" if there is none.
    const std::string& said() const { return said_; }
    /// Returns the active alarms, and the alarms that were ever shelved.
    const std::vector<KeptAlarm>& noted_alarms() const { return noted_alarms_; }

    /// From now on, `tell` is called after each transaction, in the writer's thread. Must be called once, before
    /// anything is stored.
    void start(std::function<void(WriteProgress)> tell);
    /// Processes what `tell` received. Must be called in the thread that calls the other functions.
    void note(const WriteProgress& progress);

    /// Stores a message that the machine has accepted, the number of generations that the message took, and the
    /// message's additions to the history.
    std::uint64_t record(const std::string& machine, std::string_view message, std::size_t generations,
                         std::vector<Entry> history);
    /// Stores the present state of a machine.
    std::uint64_t save(const identification::Diagnosis& diagnosis);
    std::uint64_t forget(const std::string& machine);
    /// Stores a change of the history alone.
    std::uint64_t change_history(Entry entry);
    /// While the backlog is too long, stores the states of the few machines that have the oldest messages.
    void relieve();

    /// Returns whether all accepted data is on the disk or being written, so that a restart would restore it.
    bool complete() const { return complete_; }
    /// Stores all states, which empties the backlog and makes up for any loss. `open_alarms` are the active alarms.
    void write_anew(std::vector<KeptAlarm> open_alarms, double at);
    /// Returns false if entries were lost and no write is pending; write_anew() should then be called.
    bool keeping() const { return keeping_; }
    /// Returns the last ticket given out.
    std::uint64_t last_ticket() const { return last_ticket_; }

    /// Calls `look` with the state file in the writer's thread. REQUIRES: `look` does not throw.
    void look(std::function<void(StateFile&)> look) { writer_->look(std::move(look)); }

    /// Waits until everything is on the disk and closes the file. Throws UserError if something was lost.
    void finish();

private:
    void restore_state(const KeptState& kept);
    void take_again(const StateContent& content);
    void commit_now(const Transaction& transaction);
    void fall_back(const std::string& why);
    UnwrittenState state_of(const identification::Diagnosis& diagnosis) const;
    void add_state(Transaction& transaction, const identification::Diagnosis& diagnosis);
    std::uint64_t put(Transaction transaction);

    std::filesystem::path path_;
    Diagnoses& diagnoses_;
    std::unique_ptr<StateFile> file_;
    std::unique_ptr<Writer> writer_;
    Backlog backlog_;
    std::string said_, trouble_;
    std::vector<KeptAlarm> noted_alarms_;
    std::uint64_t last_message_ = 0, trimmed_ = 0;
    std::uint64_t last_ticket_ = 0, anew_ticket_ = 0;
    bool keeping_ = true; ///< whether new entries are stored; false from a loss until write_anew()
    bool complete_ = true;
};

} // namespace placedpar::monitor
