#include "monitor/memory/state_file.hpp"

#include "monitor/memory/diagnosis_json.hpp"
#include "monitor/memory/state_identity.hpp"
#include "monitor/memory/wal_check.hpp"
#include "text/checksum.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <sys/stat.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace placedpar::monitor {

namespace fs = std::filesystem;

namespace {

/// Damage of what SQLite itself has no checksums for.
[[noreturn]] void refuse_damaged(const std::string& what) {
    throw std::runtime_error(fmt::format("it is damaged: {}", what));
}

std::int64_t row_checksum(const KeptMessage& m) { return checksum_of(fmt::format("{}", m.number), m.machine, m.text); }

std::int64_t row_checksum(const KeptState& s) { return checksum_of(s.machine, fmt::format("{}", s.taken), s.state); }

std::string way_out(const fs::path& path) {
    return fmt::format("; put a whole one there, or move it, {0}-wal and {0}-mark away and begin with nothing known",
                       path.string());
}

std::uint64_t unsigned_of(std::int64_t number) { return static_cast<std::uint64_t>(number); }

} // namespace

/// Prepared once: most of them run with every sample.
struct StateFile::Statements {
    explicit Statements(store::Database& d)
        : insert_message(d, "INSERT INTO messages VALUES(?1, ?2, ?3, ?4)"),
          trim_messages(d, "DELETE FROM messages WHERE number <= ?1"),
          put_machine(d, "INSERT INTO machines VALUES(?1, ?2, ?3, ?4) ON CONFLICT(name) DO UPDATE SET "
                         "taken = excluded.taken, state = excluded.state, checksum = excluded.checksum"),
          delete_machine(d, "DELETE FROM machines WHERE name = ?1"),
          write_ledger(d, "UPDATE ledger SET settings = ?1, trimmed = ?2, last = ?3, machines = ?4, digest = ?5, "
                          "transactions = ?6, running = ?7, checksum = ?8") {}

    store::Statement insert_message, trim_messages, put_machine, delete_machine, write_ledger;
};

StateFile::StateFile(const fs::path& path, const std::string& settings, std::uint64_t most_history,
                     StateContent& content)
    : given_(path), path_(path), settings_(settings), most_history_(most_history) {
    require_path_of_file(path_);
    if (!fs::exists(path_))
        create_state_file(path_, settings_);
    lock_ = std::make_unique<store::FileLock>(path_, fmt::format("--state {}", path_.string()), "placedpar monitor");
    path_ = fs::canonical(path_); // SQLite's own files are beside it, not beside a link
    std::error_code another_owner;
    for (const char* each : {"", "-wal", "-shm", "-mark"}) // what an earlier version made, too
        fs::permissions(path_.string() + each, fs::perms::owner_read | fs::perms::owner_write, another_owner);
    auto refuse = [&](const std::string& why) {
        throw UserError(fmt::format("{}: this state file cannot be used: {}", path.string(), why));
    };
    try {
        open(content);
    } catch (const OtherFile& other) {
        refuse(other.what());
    } catch (const store::DatabaseError& error) {
        if (!error.damage())
            refuse(error.what());
        refuse(fmt::format("it is damaged: {}{}", error.what(), way_out(path_)));
    } catch (const std::runtime_error& error) {
        refuse(fmt::format("{}{}", error.what(), way_out(path_)));
    }
}

StateFile::~StateFile() {
    try {
        close();
    } catch (const store::DatabaseError&) { // the mark is left, and the next start looks at it
    }
}

void StateFile::close() {
    if (!whole_ || !writable_)
        return;
    course_.running = false;
    commit({});
    disconnect();
    if (!fs::exists(path_.string() + "-wal"))
        mark_->remove();
}

void StateFile::disconnect() {
    writable_ = false;
    statements_.reset();
    history_.reset();
    database_.reset();
}

/// `alone`: without the file in which SQLite tells other programs where what is in the log. For that a full disk has no
/// room.
void StateFile::connect(bool alone) {
    database_.emplace(path_, false);     // it may have been removed
    database_->put_log_into_file(false); // what is refused is left as it is
    if (alone)
        database_->run("PRAGMA locking_mode = EXCLUSIVE"); // first: others read the log already
    database_->run("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON; PRAGMA synchronous = FULL");
    if (database_->text("PRAGMA journal_mode = WAL") != "wal")
        throw store::DatabaseError("SQLite cannot keep a write-ahead log there", false);
    database_->text("SELECT settings FROM ledger"); // which reads the log
}

void StateFile::open(StateContent& content) {
    require_identity(*lock_);
    content.said = check_wal(path_);
    try {
        connect(false);
    } catch (const store::DatabaseError& error) {
        if (error.damage())
            throw;
        content.trouble = error.what();
        connect(true);
    }
    require_integrity(*database_);
    read_ledger();
    require_mark();
    read_machines(content);
    read_messages(content);
    history_.emplace(*database_, most_history_);
    history_->check();
    statements_ = std::make_unique<Statements>(*database_);
    content.last_message = ledger_.last;
    try {
        if (content.trouble.empty())
            begin_running();
    } catch (const store::DatabaseError& error) {
        if (error.damage())
            throw;
        content.trouble = error.what();
    }
    writable_ = whole_ = content.trouble.empty();
}

History& StateFile::history() {
    if (!history_)
        throw store::DatabaseError("it is not open", false);
    return *history_;
}

/// Which the files beside it are, by their numbers; 0: none.
std::vector<std::uint64_t> StateFile::companions() const {
    std::vector<std::uint64_t> numbers;
    for (const char* each : {"-wal", "-shm", "-mark"}) {
        struct stat status {};
        numbers.push_back(::stat((path_.string() + each).c_str(), &status) == 0 ? status.st_ino : 0);
    }
    return numbers;
}

void StateFile::require_in_place() {
    if (lock_->is_at(given_) && companions() == companions_)
        return;
    whole_ = writable_ = false;
    throw store::DatabaseError("it, or a file beside it, has been removed or replaced", false);
}

/// Opens it again as it is to be. When it was removed, a copy of what is still open takes its place, locked before it
/// has its name, and only then is the former closed: if it is removed once more meanwhile, the next attempt has all
/// that is needed. What another has put there is left alone.
void StateFile::renew() {
    bool gone = !fs::exists(fs::symlink_status(given_)) && !fs::exists(path_);
    if (!gone && !lock_->is_at(given_))
        throw store::DatabaseError("something else is in its place: move that away", false);
    if (statements_) {
        course_.running = false;
        transact({});
        database_->put_log_into_file(true);
    }
    if (gone)
        put_copy_in_place();
    disconnect();
    mark_.reset();
    if (gone)
        for (const char* each : {"-wal", "-shm"})
            fs::remove(path_.string() + each);
    if (!fs::exists(path_.string() + "-wal"))
        fs::remove(path_.string() + "-mark");
    ledger_ = {};
    StateContent known;
    open(known);
    if (!known.trouble.empty())
        throw store::DatabaseError(known.trouble, false);
}

/// What is no longer open, since opening the last copy failed, is in the file that is locked.
void StateFile::put_copy_in_place() {
    fs::path copy =
        statements_ ? copy_state_file(*database_, path_) : write_state_file(lock_->beginning(lock_->size()), path_);
    auto lock = std::make_unique<store::FileLock>(copy, path_.string(), "placedpar monitor");
    publish(copy, path_);
    if (!lock->is_at(path_))
        throw store::DatabaseError("something else is in its place: move that away", false);
    lock_ = std::move(lock);
}

void StateFile::require_mark() {
    std::optional<std::uint64_t> mark = Mark::read(path_);
    if (course_.running && !mark)
        refuse_damaged(fmt::format("{}-mark is missing, so nobody can say whether all is there", path_.string()));
    if (mark && *mark > course_.transactions)
        refuse_damaged(fmt::format("{} transactions were committed, {} are there: {}-wal was cut or taken away, or an "
                                   "older file put in place of this one",
                                   *mark, course_.transactions, path_.string()));
}

/// That a program runs is in the file itself, not only in the log, which may be taken away.
void StateFile::begin_running() {
    database_->put_log_into_file(true);
    mark_.emplace(path_, course_.transactions);
    course_.running = true;
    transact({});
    database_->integer("PRAGMA wal_checkpoint(TRUNCATE)"); // while others read it, the log is put there later
    companions_ = companions();
}

void StateFile::read_ledger() {
    store::Statement row(
        *database_, "SELECT settings, trimmed, last, machines, digest, transactions, running, checksum FROM ledger");
    if (!row.step())
        refuse_damaged("its ledger is empty");
    std::string was = row.text(0);
    auto numbers = fmt::format("{} {} {} {} {} {}", row.integer(1), row.integer(2), row.integer(3), row.integer(4),
                               row.integer(5), row.integer(6));
    if (checksum_of(was, numbers) != row.integer(7))
        refuse_damaged("its ledger has another checksum");
    ledger_.trimmed = unsigned_of(row.integer(1));
    ledger_.last = unsigned_of(row.integer(2));
    course_ = {unsigned_of(row.integer(5)), row.integer(6) != 0};
    if (was != settings_)
        throw OtherFile(fmt::format("it was written with {}, this is {}; use the same options, or another --state file",
                                    was, settings_));
}

void StateFile::read_machines(StateContent& content) {
    store::Statement rows(*database_, "SELECT name, taken, state, checksum FROM machines ORDER BY name");
    while (rows.step()) {
        KeptState state{rows.text(0), unsigned_of(rows.integer(1)), rows.text(2)};
        if (row_checksum(state) != rows.integer(3))
            refuse_damaged(fmt::format("the state of \"{}\" has another checksum", state.machine));
        set_machine(state.machine, rows.integer(3));
        content.machines.push_back(std::move(state));
    }
    if (ledger_.digest != database_->integer("SELECT digest FROM ledger") ||
        static_cast<std::int64_t>(content.machines.size()) != database_->integer("SELECT machines FROM ledger"))
        refuse_damaged("its machines are not those of its ledger");
}

void StateFile::read_messages(StateContent& content) {
    store::Statement rows(*database_, "SELECT number, machine, text, checksum FROM messages ORDER BY number");
    std::uint64_t next = ledger_.trimmed + 1;
    for (; rows.step(); ++next) {
        KeptMessage message{unsigned_of(rows.integer(0)), rows.text(1), rows.text(2)};
        if (row_checksum(message) != rows.integer(3) || message.number != next)
            refuse_damaged(fmt::format("message {} is not what was written", next));
        content.messages.push_back(std::move(message));
    }
    if (next != ledger_.last + 1)
        refuse_damaged(fmt::format("messages {} to {} are missing", next, ledger_.last));
}

void StateFile::write_ledger() {
    auto machines = static_cast<std::int64_t>(ledger_.machines.size());
    std::int64_t running = course_.running;
    auto numbers = fmt::format("{} {} {} {} {} {}", ledger_.trimmed, ledger_.last, machines, ledger_.digest,
                               course_.transactions, running);
    statements_->write_ledger.run(settings_, ledger_.trimmed, ledger_.last, machines, ledger_.digest,
                                  course_.transactions, running, checksum_of(settings_, numbers));
}

void StateFile::commit(std::span<const Parcel> parcels) {
    bool anew = std::ranges::any_of(parcels, [](const Parcel& parcel) { return parcel.all_anew_at.has_value(); });
    if (anew && !(writable_ && lock_->is_at(given_) && companions() == companions_))
        renew();
    transact(parcels);
    require_in_place(); // after the transaction: until then what it wrote may have gone
}

void StateFile::transact(std::span<const Parcel> parcels) {
    ++course_.transactions;
    whole_ = false;
    database_->run("BEGIN IMMEDIATE");
    try {
        apply(parcels);
        write_ledger();
        database_->run("COMMIT");
        if (mark_)
            mark_->write(course_.transactions);
        whole_ = true;
    } catch (const std::exception&) {
        try {
            database_->run("ROLLBACK");
        } catch (const store::DatabaseError&) { // SQLite has done so itself
        }
        throw;
    }
}

void StateFile::apply(std::span<const Parcel> parcels) {
    for (const Parcel& parcel : parcels) {
        if (parcel.all_anew_at)
            begin_anew(*parcel.all_anew_at);
        for (const Entry& entry : parcel.entries)
            std::visit([&](const auto& each) { keep(each); }, entry);
    }
}

void StateFile::begin_anew(std::uint64_t last_message) {
    database_->run("DELETE FROM machines; DELETE FROM messages");
    ledger_ = {last_message, last_message, {}, 0};
}

/// In the ledger; without a checksum there is no such machine.
void StateFile::set_machine(const std::string& name, std::optional<std::int64_t> checksum) {
    if (auto found = ledger_.machines.find(name); found != ledger_.machines.end()) {
        ledger_.digest ^= found->second;
        ledger_.machines.erase(found);
    }
    if (checksum) {
        ledger_.digest ^= *checksum;
        ledger_.machines[name] = *checksum;
    }
}

void StateFile::keep(const KeptMessage& message) {
    statements_->insert_message.run(message.number, message.machine, message.text, row_checksum(message));
    ledger_.last = message.number;
}

void StateFile::keep(const KeptState& state) {
    std::int64_t checksum = row_checksum(state);
    statements_->put_machine.run(state.machine, state.taken, state.state, checksum);
    set_machine(state.machine, checksum);
}

void StateFile::keep(const UnwrittenState& state) {
    keep(KeptState{state.machine, state.taken, boost::json::serialize(state_json(*state.state))});
}

void StateFile::keep(const ForgottenMachine& forgotten) {
    statements_->delete_machine.run(forgotten.machine);
    set_machine(forgotten.machine, std::nullopt);
    history_->forget(forgotten.machine);
}

void StateFile::keep(const TrimmedMessages& messages) {
    statements_->trim_messages.run(messages.up_to);
    ledger_.trimmed = messages.up_to;
}

} // namespace placedpar::monitor
