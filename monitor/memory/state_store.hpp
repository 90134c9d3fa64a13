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

/// Keeps what is known of all machines over a restart: in a state file, of each machine a state and the messages that
/// it has taken since. A diagnosis is a function of its messages: taking them again gives the same one to the bit.
///
/// 1. What is to be kept is given to a thread that writes; each function that does so gives a ticket. When all up to
///    that is on the disk, or lost, `tell` is called.
/// 2. What was lost leaves a hole: nothing is kept any more until write_anew() has begun again with all states.
/// 3. All functions are called from one thread.
class StateStore {
public:
    /// A longer backlog goes into states, the oldest first: a restart would have to do it all again.
    static constexpr std::size_t most_backlog_bytes = 8u << 20;
    static constexpr std::uint64_t most_backlog_generations = 100000; ///< one to five seconds of work

    /// Opens the file and restores what is in it. Throws UserError naming the file when it cannot be used.
    StateStore(const std::filesystem::path& path, Diagnoses& diagnoses, std::uint64_t most_history);
    ~StateStore();

    /// Why what is known cannot be kept from the beginning on, as on a full disk; empty: it can.
    const std::string& trouble() const { return trouble_; }
    /// A sentence for people; empty when there was nothing.
    const std::string& said() const { return said_; }
    /// Those that had not been cleared, or were put on the shelf.
    const std::vector<KeptAlarm>& noted_alarms() const { return noted_alarms_; }

    /// From now on, after each transaction, in the thread that writes. To be called once, before anything is kept.
    void start(std::function<void(WriteProgress)> tell);
    /// To be called with what `tell` was given, in the thread of the others.
    void note(const WriteProgress& progress);

    /// A message that the machine has taken, which cost so many generations, and what it added to the history.
    std::uint64_t record(const std::string& machine, std::string_view message, std::size_t generations,
                         std::vector<Entry> history);
    /// The machine as it is now.
    std::uint64_t save(const identification::Diagnosis& diagnosis);
    std::uint64_t forget(const std::string& machine);
    /// Something about the history alone.
    std::uint64_t change_history(Entry entry);
    /// Keeps the states of some machines whose messages are the oldest while the backlog is too long.
    void relieve();

    /// Would a restart give all that has been kept, or is on its way to the disk?
    bool complete() const { return complete_; }
    /// Keeps all states: the next start has nothing to take again, and what was lost is made good. `open_alarms` are
    /// those that hold now.
    void write_anew(std::vector<KeptAlarm> open_alarms, double at);
    /// Is anything on its way to the disk, after a loss? If not, it is time to begin anew.
    bool keeping() const { return keeping_; }
    /// The last ticket given.
    std::uint64_t last_ticket() const { return last_ticket_; }

    /// Has the history looked into, in the thread that writes. `look` may throw nothing.
    void look(std::function<void(StateFile&)> look) { writer_->look(std::move(look)); }

    /// Waits until all is on the disk and closes the file. Throws UserError when some of it was lost.
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
    bool keeping_ = true; ///< what comes is put; false after a loss, until write_anew()
    bool complete_ = true;
};

} // namespace placedpar::monitor
