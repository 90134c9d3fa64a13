#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::monitor {

/// What could be read of a journal, of which a kill or a loss of power may have damaged the end.
struct JournalContent {
    std::uint64_t epoch = 0;          ///< of the state file that the records come after
    std::vector<std::string> records; ///< up to the first damage
    std::size_t good_bytes = 0;       ///< whole records, from the start
    std::size_t damaged_bytes = 0;    ///< the rest: the torn last record of a killed writer, or worse
};

/// An append-only file of records, a line each: CRC-32 in hexadecimal, a blank, the record. The first line
/// names the epoch. One program at a time may have a journal open.
///
/// 1. A record is written by one system call before its message is answered: a kill of the program loses none that was
///    answered, and tears at most the last.
/// 2. A loss of power loses what was appended since the last sync().
class Journal {
public:
    /// Opens or makes the file and takes its lock. Throws UserError naming the file and the reason, such as that
    /// another program has it.
    explicit Journal(std::filesystem::path path);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    JournalContent read() const;
    /// Cuts the damage off.
    void truncate(std::size_t good_bytes);
    /// Empties it: from now on, records come after the state file of this epoch.
    void begin(std::uint64_t epoch);

    /// REQUIRES: no newline in the record. Throws UserError, having appended nothing.
    void append(std::string_view record);
    std::size_t bytes() const { return bytes_; }
    /// To the disk itself. Safe to call from another thread. Throws UserError.
    void sync() const;

private:
    [[noreturn]] void fail(const char* what) const;

    std::filesystem::path path_;
    int file_;
    std::size_t bytes_ = 0;
};

} // namespace placedpar::monitor
