#pragma once

#include "monitor/memory/entries.hpp"
#include "monitor/memory/history.hpp"
#include "store/database.hpp"
#include "store/file_lock.hpp"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar::monitor {

/// What a state file held when it was opened.
struct StateContent {
    std::vector<KeptState> machines;
    std::vector<KeptMessage> messages; ///< those that are not in them, by number
    std::uint64_t last_message = 0;    ///< the number of the last one ever kept
    std::string said;                  ///< what an operator should know of opening it; may be ""
    std::string trouble;               ///< why it can be read, but not written, as on a full disk; "": it can
};

/// The state file: a database of SQLite with the machines' states, the messages that came after them, and the history.
///
/// 1. What commit() was given is on the disk when it returns, and all of it or nothing after any kill or loss of power:
///    SQLite's rollback journal, there during a transaction only, sees to that.
/// 2. Every row has a checksum over all that it holds. The ledger, a single row, says which messages there are, and
///    what the checksums of all other rows come to. So a file that is damaged or cut is refused, and so is one whose
///    journal was when a kill had left one, unless nothing is stored where the damage is.
///    A file that is removed or replaced is noticed before commit() returns, which throws then.
/// 3. It is locked: one program at a time.
/// 4. One thread at a time.
class StateFile {
public:
    /// Makes the file when there is none; else checks it, row by row, and gives what is in it. One of an earlier
    /// version is put aside. `settings` are what its states depend on. Throws UserError, naming the file, saying what
    /// is wrong and what to do.
    StateFile(const std::filesystem::path& path, const std::string& settings, std::uint64_t most_history,
              StateContent& content);
    ~StateFile();

    /// In one transaction. Throws UserError, DatabaseError too, when what it was given may be lost; then, and after a
    /// trouble with opening, the next parcel that is committed must be one that begins all anew, with which a file that
    /// was removed is made again, its history included.
    void commit(std::span<const Transaction> transactions);
    /// Throws DatabaseError when there is none: the file could not be made again.
    History& history();

private:
    struct Statements;

    /// Messages trimmed + 1 to last are there.
    struct Ledger {
        std::uint64_t trimmed = 0, last = 0;
    };

    void lock();
    void open(StateContent& content);
    void connect();
    std::string trouble_with_writing();
    void renew();
    void put_copy_in_place();
    void require_in_place() const;
    void transact(std::span<const Transaction> transactions);
    /// Gives the sum of the other rows' checksums, by the ledger; read_machines() gives that of its rows.
    std::uint64_t read_ledger();
    std::uint64_t read_machines(StateContent& content);
    void read_messages(StateContent& content);
    void write_ledger();
    void apply(std::span<const Transaction> transactions);
    void begin_anew(std::uint64_t last_message);
    void keep(const KeptMessage& message);
    void keep(const UnwrittenState& state);
    void keep(const KeptState& state);
    void keep(const ForgottenMachine& machine);
    void keep(const TrimmedMessages& messages);
    void keep(const KeptEstimate& estimate) { history_->keep(estimate); }
    void keep(const KeptAlarm& alarm) { history_->keep(alarm); }
    void keep(const ChangedAlarm& change) { history_->change(change.alarm); }
    void keep(const OpenAlarms& open) { history_->reconcile(open); }

    std::filesystem::path given_, path_; ///< which may be a link, and what it leads to
    std::string settings_;
    std::uint64_t most_history_;
    std::unique_ptr<store::FileLock> lock_;
    std::optional<store::Database> database_;
    std::optional<History> history_;
    std::unique_ptr<Statements> statements_;
    Ledger ledger_;
};

} // namespace placedpar::monitor
