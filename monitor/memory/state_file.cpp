#include "monitor/memory/state_file.hpp"

#include "monitor/memory/diagnosis_json.hpp"
#include "monitor/memory/state_identity.hpp"
#include "text/checksum.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace placedpar::monitor {

namespace fs = std::filesystem;

namespace {

/// Reports damage that SQLite, which has no checksums, cannot find.
[[noreturn]] void refuse_damaged(const std::string& what) {
    throw std::runtime_error(fmt::format("the file is damaged: {}", what));
}

std::int64_t row_checksum(const KeptMessage& m) { return checksum_of(fmt::format("{}", m.number), m.machine, m.text); }

std::int64_t row_checksum(const KeptState& s) { return checksum_of(s.machine, fmt::format("{}", s.taken), s.state); }

std::string way_out(const fs::path& path) {
    return fmt::format("; restore an undamaged copy and remove {}-journal, or move {} away and start without "
                       "known machines",
                       path.filename().string(), path.string());
}

std::uint64_t unsigned_of(std::int64_t number) { return static_cast<std::uint64_t>(number); }

} // namespace

/// These statements are prepared once, since most of them run with every sample.
struct StateFile::Statements {
    explicit Statements(store::Database& d)
        : insert_message(d, "INSERT INTO messages VALUES(?1, ?2, ?3, ?4)"),
          trim_messages(d, "DELETE FROM messages WHERE number <= ?1"),
          put_machine(d, "INSERT INTO machines VALUES(?1, ?2, ?3, ?4) ON CONFLICT(name) DO UPDATE SET "
                         "taken = excluded.taken, state = excluded.state, checksum = excluded.checksum"),
          delete_machine(d, "DELETE FROM machines WHERE name = ?1"), sum(d, "SELECT sum FROM ledger"),
          write_ledger(d, "UPDATE ledger SET trimmed = ?1, last = ?2, checksum = ?3") {}

    store::Statement insert_message, trim_messages, put_machine, delete_machine, sum, write_ledger;
};

StateFile::StateFile(const fs::path& path, const std::string& settings, std::uint64_t most_history,
                     StateContent& content)
    : given_(path), path_(path), settings_(settings), most_history_(most_history) {
    require_path_of_file(path_);
    if (!fs::exists(path_)) {
        if (fs::exists(place_aside(path_))) // an earlier start ended after it had renamed the old file
            content.said = told_aside(path_);
        create_state_file(path_, settings_);
    }
    lock();
    path_ = fs::canonical(path_); // SQLite puts its journal beside the file itself, not beside a link to the file
    std::error_code another_owner;
    fs::permissions(path_, fs::perms::owner_read | fs::perms::owner_write, another_owner);
    auto refuse = [&](const std::string& why) {
        throw UserError(fmt::format("{}: this state file cannot be used: {}", path.string(), why));
    };
    try {
        if (require_identity(*lock_) == earlier_file_version) {
            content.said = put_aside(path_);
            create_state_file(path_, settings_);
            lock();
        }
        open(content);
    } catch (const OtherFile& other) {
        refuse(other.what());
    } catch (const store::DatabaseError& error) {
        if (!error.damage())
            refuse(error.what());
        refuse(fmt::format("the file is damaged: {}{}", error.what(), way_out(path_)));
    } catch (const std::runtime_error& error) {
        refuse(fmt::format("{}{}", error.what(), way_out(path_)));
    }
}

StateFile::~StateFile() = default;

void StateFile::lock() {
    lock_ = std::make_unique<store::FileLock>(path_, fmt::format("--state {}", path_.string()), "placedpar monitor");
}

void StateFile::connect() {
    database_.emplace(path_, false); // does not create the file if it has been removed
    database_->run("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON; PRAGMA synchronous = EXTRA; "
                   "PRAGMA journal_mode = DELETE");
}

void StateFile::open(StateContent& content) {
    connect();
    require_integrity(*database_);
    history_.emplace(*database_, most_history_);
    const std::uint64_t expected = read_ledger(), found = read_machines(content) + history_->check();
    if ((found & sum_mask) != expected)
        refuse_damaged("its rows do not match the sum of their checksums");
    read_messages(content);
    content.last_message = ledger_.last;
    statements_ = std::make_unique<Statements>(*database_);
    content.trouble = trouble_with_writing();
}

/// Returns the reason why the file cannot be written, or "". Writes one page as a test, because SQLite would skip a
/// write that changes nothing.
std::string StateFile::trouble_with_writing() {
    try {
        database_->run("BEGIN IMMEDIATE; UPDATE ledger SET last = last + 1; UPDATE ledger SET last = last - 1; COMMIT");
        return "";
    } catch (const store::DatabaseError& error) {
        database_->roll_back();
        if (error.damage())
            throw;
        return error.what();
    }
}

History& StateFile::history() {
    if (!history_)
        throw store::DatabaseError("the file is not open", false);
    return *history_;
}

void StateFile::require_in_place() const {
    if (!statements_ || !lock_->is_at(given_))
        throw store::DatabaseError("the file was removed or replaced", false);
}

/// Opens the file again after an error. If the file was removed, a copy replaces it. This program locks the copy before
/// the copy gets the file's name. If the file is removed again before that, the next attempt can still succeed. A file
/// that another program has put in this place stays unchanged.
void StateFile::renew() {
    const bool gone = !fs::exists(fs::symlink_status(given_)) && !fs::exists(path_);
    if (!gone && !lock_->is_at(given_))
        throw store::DatabaseError("another file has taken its name: move that file away", false);
    statements_.reset();
    history_.reset();
    database_.reset();
    if (gone)
        put_copy_in_place();
    StateContent known;
    open(known);
    if (!known.trouble.empty())
        throw store::DatabaseError(known.trouble, false);
}

/// Writes a copy of the removed file. Its content can still be read, because this program has the file open.
void StateFile::put_copy_in_place() {
    fs::path copy = write_state_file(lock_->beginning(lock_->size()), path_);
    auto lock = std::make_unique<store::FileLock>(copy, path_.string(), "placedpar monitor");
    publish(copy, path_);
    if (!lock->is_at(path_))
        throw store::DatabaseError("another file has taken its name: move that file away", false);
    lock_ = std::move(lock);
}

std::uint64_t StateFile::read_ledger() {
    store::Statement row(*database_, "SELECT settings, trimmed, last, sum, checksum FROM ledger");
    if (!row.step())
        refuse_damaged("its table \"ledger\" is empty");
    const std::string was = row.text(0);
    ledger_ = {unsigned_of(row.integer(1)), unsigned_of(row.integer(2))};
    const std::uint64_t sum = unsigned_of(row.integer(3));
    if (ledger_checksum(was, ledger_.trimmed, ledger_.last, sum) != row.integer(4))
        refuse_damaged("its table \"ledger\" has a wrong checksum");
    if (was != settings_)
        throw OtherFile(fmt::format("the file was written with {}, but this monitor has {}; use the same "
                                    "options, or another --state file",
                                    was, settings_));
    return sum;
}

std::uint64_t StateFile::read_machines(StateContent& content) {
    std::uint64_t sum = 0;
    store::Statement rows(*database_, "SELECT name, taken, state, checksum FROM machines ORDER BY name");
    while (rows.step()) {
        KeptState state{rows.text(0), unsigned_of(rows.integer(1)), rows.text(2)};
        if (row_checksum(state) != rows.integer(3))
            refuse_damaged(fmt::format("the state of \"{}\" has a wrong checksum", state.machine));
        sum += unsigned_of(rows.integer(3));
        content.machines.push_back(std::move(state));
    }
    return sum;
}

void StateFile::read_messages(StateContent& content) {
    store::Statement rows(*database_, "SELECT number, machine, text, checksum FROM messages ORDER BY number");
    std::uint64_t next = ledger_.trimmed + 1;
    for (; rows.step(); ++next) {
        KeptMessage message{unsigned_of(rows.integer(0)), rows.text(1), rows.text(2)};
        if (row_checksum(message) != rows.integer(3) || message.number != next)
            refuse_damaged(fmt::format("message {} was changed after it was written", next));
        content.messages.push_back(std::move(message));
    }
    if (next != ledger_.last + 1)
        refuse_damaged(fmt::format("messages {} to {} are missing", next, ledger_.last));
}

void StateFile::write_ledger() {
    const std::uint64_t sum = unsigned_of(statements_->sum.only_integer());
    statements_->write_ledger.run(ledger_.trimmed, ledger_.last,
                                  ledger_checksum(settings_, ledger_.trimmed, ledger_.last, sum));
}

void StateFile::commit(std::span<const Transaction> transactions) {
    bool anew = std::ranges::any_of(transactions,
                                    [](const Transaction& transaction) { return transaction.all_anew_at.has_value(); });
    if (anew && !(statements_ && lock_->is_at(given_)))
        renew();
    require_in_place();
    transact(transactions);
    require_in_place(); // if the file has been removed, the new data are lost
}

void StateFile::transact(std::span<const Transaction> transactions) {
    database_->run("BEGIN IMMEDIATE");
    try {
        apply(transactions);
        write_ledger();
        database_->run("COMMIT");
    } catch (const std::exception&) {
        database_->roll_back();
        throw;
    }
}

void StateFile::apply(std::span<const Transaction> transactions) {
    for (const Transaction& transaction : transactions) {
        if (transaction.all_anew_at)
            begin_anew(*transaction.all_anew_at);
        for (const Entry& entry : transaction.entries)
            std::visit([&](const auto& each) { keep(each); }, entry);
    }
}

void StateFile::begin_anew(std::uint64_t last_message) {
    database_->run("DELETE FROM machines; DELETE FROM messages");
    ledger_ = {last_message, last_message};
}

void StateFile::keep(const KeptMessage& message) {
    statements_->insert_message.run(message.number, message.machine, message.text, row_checksum(message));
    ledger_.last = message.number;
}

void StateFile::keep(const KeptState& state) {
    statements_->put_machine.run(state.machine, state.taken, state.state, row_checksum(state));
}

void StateFile::keep(const UnwrittenState& state) {
    keep(KeptState{state.machine, state.taken, boost::json::serialize(state_json(*state.state))});
}

void StateFile::keep(const ForgottenMachine& forgotten) {
    statements_->delete_machine.run(forgotten.machine);
    history_->forget(forgotten.machine);
}

void StateFile::keep(const TrimmedMessages& messages) {
    statements_->trim_messages.run(messages.up_to);
    ledger_.trimmed = messages.up_to;
}

} // namespace placedpar::monitor
