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

/// The content of a state file when it was opened.
struct StateContent {
    std::vector<KeptState> machines;
    /// The messages that the machines accepted after these states, in order of their numbers.
    std::vector<KeptMessage> messages;
    std::uint64_t last_message = 0; ///< the number of the last message ever stored
    std::string said;               ///< a message for the operator about opening the file; may be ""
    std::string trouble; ///< why the file can be read but not written, such as a full disk; "" if it can be written
};

/// The state file, from which the service restores its diagnoses after a restart. It is an SQLite database with the
/// states of the machines' diagnoses, the messages after those states, and the history of estimates and alarms.
///
/// 1. When commit() returns, its transactions are on the disk. After a kill or a loss of power, the file has either all
///    transactions of a commit() or none. SQLite's rollback journal, which exists only during a transaction, guarantees
///    this.
/// 2. Damage is found. Every row has a checksum of its values. One row, the ledger, states which messages the file has,
///    and the sum of the checksums of all other rows except the messages. A damaged or truncated file is therefore
///    refused if the damaged part has data. A file whose rollback journal was damaged after a kill is refused, too. If
///    the file is removed or replaced before commit() returns, commit() throws.
/// 3. The file is locked: only one program can open it at a time.
/// 4. Only one thread may use an object at a time.
class StateFile {
public:
    /// Opens the file, checks every row and reads its content. If no file exists, creates it. Renames a file of an
    /// earlier version. `settings` are the options on which the states depend. Throws UserError, which names the file,
    /// the error and the remedy.
    StateFile(const std::filesystem::path& path, const std::string& settings, std::uint64_t most_history,
              StateContent& content);
    ~StateFile();

    /// Writes all transactions in one SQLite transaction. Throws UserError (DatabaseError is a subclass) if some may be
    /// lost. After such an error, or if StateContent::trouble was not empty, the next transaction must have
    /// `all_anew_at`, that is, replace the whole content. Such a transaction also recreates a file that was removed,
    /// with its history.
    void commit(std::span<const Transaction> transactions);
    /// Returns the history in the file. Throws DatabaseError if the file is not open because it could not be recreated.
    History& history();

private:
    struct Statements;

    /// The row that states which messages the file has: the messages `trimmed` + 1 to `last`.
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
    /// Returns the sum of checksums in the ledger. read_machines() returns the sum over the rows of machines.
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

    std::filesystem::path given_, path_; ///< the path as given, which may be a link, and the path that it leads to
    std::string settings_;
    std::uint64_t most_history_;
    std::unique_ptr<store::FileLock> lock_;
    std::optional<store::Database> database_;
    std::optional<History> history_;
    std::unique_ptr<Statements> statements_;
    Ledger ledger_;
};

} // namespace placedpar::monitor
