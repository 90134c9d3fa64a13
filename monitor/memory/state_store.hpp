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

/// Keeps all diagnoses over a restart of the service. The state file has a state of each machine (excavator) and the
/// messages that the machine's diagnosis accepted later. A diagnosis depends only on its messages. Processing the
/// messages again therefore restores it bit by bit.
///
/// 1. A separate thread, the writer's thread, writes the file. Each function that stores something returns a ticket, a
///    rising number. The callback of start() reports when everything up to a ticket is on the disk or lost.
/// 2. If entries are lost, for example because the disk is full, nothing is stored until write_anew() has stored all
///    states again.
/// 3. All functions are called from one thread.
class StateStore {
public:
    /// The greatest size of the backlog, the messages that are not part of a saved state. A restart must process them
    /// again. When the backlog is larger, relieve() saves the states of the machines with the oldest messages.
    static constexpr std::size_t most_backlog_bytes = 8u << 20;
    /// The greatest number of generations for the backlog's messages. A restart makes them again in 1 to 5 s.
    static constexpr std::uint64_t most_backlog_generations = 100000;

    /// Opens the file and restores its content. Throws UserError, naming the file, if the file cannot be used.
    StateStore(const std::filesystem::path& path, Diagnoses& diagnoses, std::uint64_t most_history);
    ~StateStore();

    /// Returns why the file could not be written when it was opened, for example because the disk was full; "" if it
    /// could be written.
    const std::string& trouble() const { return trouble_; }
    /// Returns a message for the operator about opening the file, or "".
    const std::string& said() const { return said_; }
    /// Returns the active alarms, and the alarms that an operator ever shelved, that is, suppressed for some time.
    const std::vector<KeptAlarm>& noted_alarms() const { return noted_alarms_; }

    /// Starts the writer's thread, which calls `tell` after each transaction. Call this function once, before anything
    /// is stored.
    void start(std::function<void(WriteProgress)> tell);
    /// Processes what `tell` received. Call this function in the thread that calls the other functions.
    void note(const WriteProgress& progress);

    /// Stores a message that the machine's diagnosis has accepted, and the entries that the message adds to the
    /// history. `generations` is the number of generations that the search made for this message.
    std::uint64_t record(const std::string& machine, std::string_view message, std::size_t generations,
                         std::vector<Entry> history);
    /// Stores the present state of a machine.
    std::uint64_t save(const identification::Diagnosis& diagnosis);
    std::uint64_t forget(const std::string& machine);
    /// Stores a change of the history alone.
    std::uint64_t change_history(Entry entry);
    /// While the backlog is too long, stores the states of the few machines that have the oldest messages.
    void relieve();

    /// Returns whether all accepted data is on the disk or being written, so that a restart would restore all of it.
    bool complete() const { return complete_; }
    /// Stores all states. This empties the backlog and replaces entries that were lost. `open_alarms` are the active
    /// alarms.
    void write_anew(std::vector<KeptAlarm> open_alarms, double at);
    /// Returns whether entries are being stored. If the result is false, entries were lost, and the caller should call
    /// write_anew().
    bool keeping() const { return keeping_; }
    /// Returns the last ticket given out.
    std::uint64_t last_ticket() const { return last_ticket_; }

    /// Calls `look` with the state file in the writer's thread, to read the history. REQUIRES: `look` does not throw.
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
