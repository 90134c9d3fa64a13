#pragma once

#include "monitor/memory/entries.hpp"
#include "monitor/memory/history.hpp"
#include "monitor/memory/mark.hpp"
#include "store/database.hpp"
#include "store/file_lock.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
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
/// 1. What commit() was given is on the disk when it returns, and all of it or nothing after any kill or loss of power.
/// 2. Every row has a checksum over all that it holds. The ledger, a single row, says which messages and machines there
///    are, and the mark how many transactions. So a file that is damaged or cut, or whose log is, is refused, unless
///    nothing is stored where the damage is. Only after a loss of power is the last transaction, of which nobody was
///    told, left out and that said.
///    A file that is removed or replaced, or one beside it, is noticed before commit() returns, which throws then.
/// 3. It is locked: one program at a time.
/// 4. One thread at a time.
class StateFile {
public:
    /// Makes the file when there is none; else checks it, row by row, and gives what is in it. `settings` are what its
    /// states depend on. Throws UserError, naming the file, saying what is wrong and what to do.
    StateFile(const std::filesystem::path& path, const std::string& settings, std::uint64_t most_history,
              StateContent& content);
    /// Puts the log into the file, which is then all there is.
    ~StateFile();

    /// In one transaction. Throws UserError, DatabaseError too, when what it was given may be lost; then, and after a
    /// trouble with opening, the next parcel that is committed must be one that begins all anew, with which a file that
    /// was removed is made again, its history included.
    void commit(std::span<const Parcel> parcels);
    /// Throws DatabaseError when there is none: the file could not be made again.
    History& history();

private:
    struct Statements;

    /// Messages trimmed + 1 to last are there, and these machines.
    struct Ledger {
        std::uint64_t trimmed = 0, last = 0;
        std::map<std::string, std::int64_t> machines; ///< the checksums of their rows
        std::int64_t digest = 0;                      ///< those, one exclusive or the other
    };
    /// Of the ledger, too, and not begun anew: what the mark is compared with.
    struct Course {
        std::uint64_t transactions = 0;
        bool running = false; ///< a program has it, or had it until it was killed: there is a mark
    };

    void open(StateContent& content);
    void connect(bool alone);
    void renew();
    void put_copy_in_place();
    void disconnect();
    void require_in_place();
    std::vector<std::uint64_t> companions() const;
    void transact(std::span<const Parcel> parcels);
    void read_ledger();
    void require_mark();
    void begin_running();
    void close();
    void read_machines(StateContent& content);
    void read_messages(StateContent& content);
    void write_ledger();
    void apply(std::span<const Parcel> parcels);
    void begin_anew(std::uint64_t last_message);
    void set_machine(const std::string& name, std::optional<std::int64_t> checksum);
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
    std::optional<Mark> mark_;
    Ledger ledger_;
    Course course_;
    bool whole_ = true;                     ///< no transaction has failed since all began anew
    bool writable_ = false;                 ///< it has been opened as it is to be
    std::vector<std::uint64_t> companions_; ///< as they were when it was opened
};

} // namespace placedpar::monitor
