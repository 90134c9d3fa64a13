#include "monitor/memory/state_identity.hpp"

#include "monitor/memory/history.hpp"
#include "text/checksum.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string_view>

namespace placedpar::monitor {

namespace fs = std::filesystem;

namespace {

constexpr std::uint32_t application_id = 0x50506d6f; // "PPmo"

/// Returns the triggers that change the ledger's sum of checksums whenever a row of the table changes. The sum has 62
/// bits, so adding to it never overflows.
std::string triggers(const char* table) {
    constexpr const char* trigger = "CREATE TRIGGER {0}_{1} AFTER {2} ON {0} BEGIN "
                                    "UPDATE ledger SET sum = sum{3} & {4}; END;";
    auto share = [](const char* sign, const char* row) {
        return fmt::format(" {} ({}.checksum & {})", sign, row, sum_mask);
    };
    const std::string more = share("+", "new"), less = share("-", "old");
    return fmt::format(fmt::runtime(trigger), table, "inserted", "INSERT", more, sum_mask) +
           fmt::format(fmt::runtime(trigger), table, "updated", "UPDATE", less + more, sum_mask) +
           fmt::format(fmt::runtime(trigger), table, "deleted", "DELETE", less, sum_mask);
}

/// Returns the statements that create the tables. The row `ledger` contains the settings, since the stored states are
/// useless with other settings.
std::string schema() {
    return std::string("CREATE TABLE ledger(id INTEGER PRIMARY KEY CHECK(id = 1), settings TEXT NOT NULL, "
                       "trimmed INTEGER NOT NULL, last INTEGER NOT NULL, sum INTEGER NOT NULL, "
                       "checksum INTEGER NOT NULL);"
                       "CREATE TABLE machines(name TEXT PRIMARY KEY, taken INTEGER NOT NULL, state TEXT NOT NULL, "
                       "checksum INTEGER NOT NULL);"
                       "CREATE TABLE messages(number INTEGER PRIMARY KEY, machine TEXT NOT NULL, text TEXT NOT NULL, "
                       "checksum INTEGER NOT NULL);") +
           History::schema + triggers("machines") + triggers("estimates") + triggers("alarms");
}

/// Writes a file, or the names in a directory, through to the disk.
void sync_path(const fs::path& path) {
    int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0 || ::fsync(file) != 0) {
        int reason = errno;
        if (file >= 0)
            ::close(file);
        throw UserError(fmt::format("{}: cannot be written to the disk: {}", path.string(), std::strerror(reason)));
    }
    ::close(file);
}

/// Reads a 32-bit field of SQLite's header (https://www.sqlite.org/fileformat2.html, section 1.3).
std::uint32_t header_word(std::string_view header, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<unsigned char>(header[at + i]);
    return value;
}

/// Creates an empty file for SQLite. SQLite gives its companion files the same permissions, whatever the umask is.
fs::path begin_file(const fs::path& path) {
    fs::path made = path;
    made += fmt::format(".new-{}", ::getpid());
    ::unlink(made.c_str());
    int file = ::open(made.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file < 0)
        throw UserError(fmt::format("--state {}: the file cannot be created: {}", path.string(), std::strerror(errno)));
    ::close(file);
    return made;
}

} // namespace

void publish(const fs::path& made, const fs::path& path) {
    sync_path(made);
    if (::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, path.c_str(), RENAME_NOREPLACE) != 0) {
        int reason = errno;
        fs::remove(made);
        if (reason != EEXIST)
            throw UserError(
                fmt::format("--state {}: the file cannot be created: {}", path.string(), std::strerror(reason)));
    }
    sync_path(fs::absolute(path).parent_path());
}

fs::path write_state_file(const std::string& bytes, const fs::path& path) {
    fs::path made = begin_file(path);
    std::ofstream out(made, std::ios::binary);
    if (!out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush())
        throw UserError(fmt::format("--state {}: the file cannot be created: {}", path.string(), std::strerror(errno)));
    return made;
}

void require_path_of_file(const fs::path& path) {
    if (is_standard_stream(path))
        throw UserError("-: standard output cannot be a state file; name a file, which need not exist yet");
    if (fs::exists(path)) {
        if (!fs::is_regular_file(path))
            throw UserError(fmt::format("{}: this is {}, not a state file; name a file, which need not exist yet",
                                        path.string(), fs::is_directory(path) ? "a folder" : "a device"));
        return;
    }
    if (fs::is_symlink(path))
        throw UserError(fmt::format("{}: this symbolic link leads to a missing file; restore the file, or remove "
                                    "the link",
                                    path.string()));
    for (const char* part : {"-journal", "-wal"}) // journals of this version and of an earlier version
        if (fs::exists(path.string() + part))
            throw UserError(fmt::format("{0}: the file is missing, but its last changes are in {0}{1}; restore "
                                        "the file, or move {0}{1} away, too, and start without known machines",
                                        path.string(), part));
    if (fs::exists(path.string() + ".journal"))
        throw UserError(fmt::format("{0}: the file is missing, but {0}.journal exists, the journal of an earlier "
                                    "placedpar monitor, which this version cannot read; move the journal away "
                                    "and start without known machines",
                                    path.string()));
}

void create_state_file(const fs::path& path, const std::string& settings) {
    fs::path made = begin_file(path);
    try {
        store::Database database(made);
        database.run("PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF"); // publish() syncs the file later
        database.run(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", application_id, file_version));
        database.run(schema());
        store::Statement(database, "INSERT INTO ledger VALUES(1, ?1, 0, 0, 0, ?2)")
            .run(settings, ledger_checksum(settings, 0, 0, 0));
    } catch (const store::DatabaseError& error) {
        std::error_code ignored;
        fs::remove(made, ignored);
        throw UserError(fmt::format("--state {}: the file cannot be created: {}", path.string(), error.what()));
    }
    publish(made, path);
}

std::int64_t ledger_checksum(const std::string& settings, std::uint64_t trimmed, std::uint64_t last,
                             std::uint64_t sum) {
    return checksum_of(settings, fmt::format("{} {} {}", trimmed, last, sum));
}

std::uint32_t require_identity(const store::FileLock& file) {
    std::string header = file.beginning(100);
    if (header.empty())
        throw std::runtime_error("the file is empty");
    if (header.find("placedpar_monitor_state") != header.npos)
        throw OtherFile("an earlier placedpar monitor wrote the file as JSON, which this version cannot read; "
                        "use another --state file");
    if (header.find("placedpar-monitor-journal") != header.npos)
        throw OtherFile("the file is the journal of an earlier placedpar monitor, which this version cannot "
                        "read; use another --state file");
    if (header.size() < 100 || !header.starts_with(std::string_view("SQLite format 3\0", 16)))
        throw std::runtime_error("the file is not a state file of the monitor");
    if (header_word(header, 68) != application_id)
        throw OtherFile(fmt::format("the file is a database of another program (application_id {:#010x}; a state "
                                    "file has {:#010x}); use another --state file",
                                    header_word(header, 68), application_id));
    const std::uint32_t version = header_word(header, 60);
    if (version != file_version && version != earlier_file_version)
        throw OtherFile(
            fmt::format("the file has version {}, but this program reads version {}; use another --state file", version,
                        file_version));
    return version;
}

std::string place_aside(const fs::path& path) {
    return fmt::format("{}.version-{}", path.string(), earlier_file_version);
}

std::string put_aside(const fs::path& path) {
    const std::string aside = place_aside(path);
    if (fs::exists(aside))
        throw OtherFile(fmt::format("the file has version {}, and so has {}: move one of the two away",
                                    earlier_file_version, aside));
    for (const char* part :
         {"-wal", "-shm", "-mark", "-journal", ""}) // the file itself is last, because the other files belong to it
        if (fs::exists(path.string() + part))
            fs::rename(path.string() + part, aside + part);
    return told_aside(path);
}

std::string told_aside(const fs::path& path) {
    return fmt::format(
        "{}: the file had version {}, from an earlier placedpar monitor: it was renamed to {}, and all machines "
        "start anew",
        path.string(), earlier_file_version, place_aside(path));
}

void require_integrity(store::Database& database) {
    std::string found = database.text("PRAGMA integrity_check(1)");
    if (found != "ok")
        throw std::runtime_error(fmt::format("the file is damaged: {}", found));
    std::string tables, expected = schema();
    store::Statement all(database, "SELECT sql FROM sqlite_schema WHERE sql IS NOT NULL ORDER BY rowid");
    while (all.step())
        tables += all.text(0) + ";";
    if (tables != expected)
        throw std::runtime_error("the file is damaged: its tables differ from those of a state file");
}

} // namespace placedpar::monitor
