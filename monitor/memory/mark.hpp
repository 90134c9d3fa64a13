#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace placedpar::monitor {

/// How many transactions a state file has seen, in a small file beside it (its path with "-mark"): a write-ahead log
/// that was cut between two transactions, or taken away, is whole to SQLite, and the mark says that it is not.
///
/// Written after each transaction, not brought to the disk itself: after a loss of power it may say too few, never too
/// many.
class Mark {
public:
    /// None when there is no such file. Throws std::runtime_error when it is damaged.
    static std::optional<std::uint64_t> read(const std::filesystem::path& state_file);

    /// Makes the file, or opens it, and brings it to the disk. This and the rest throw DatabaseError.
    Mark(const std::filesystem::path& state_file, std::uint64_t transactions);
    ~Mark();
    Mark(const Mark&) = delete;
    Mark& operator=(const Mark&) = delete;

    void write(std::uint64_t transactions);
    /// It is no longer needed: the state file has everything.
    void remove();

private:
    [[noreturn]] void fail() const;

    std::filesystem::path path_;
    int file_;
};

} // namespace placedpar::monitor
