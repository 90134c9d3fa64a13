#pragma once

#include <filesystem>
#include <string>

namespace placedpar::store {

/// A lock on an existing file. All names of the file, symbolic and hard links included, lead to the same lock. The
/// system releases it when the program ends, in whatever way. SQLite's own locks are of another kind, so that both can
/// be had.
class FileLock {
public:
    /// Throws UserError when another program holds the lock, or the file cannot be opened for reading and writing.
    /// Messages call the file `shown`, and the other program `user`: "placedpar monitor".
    FileLock(const std::filesystem::path& path, const std::string& shown, const std::string& user);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    /// Returns the first bytes of the file, at most the given number.
    std::string beginning(std::size_t bytes) const;
    std::size_t size() const;
    /// Returns whether the path still leads to the locked file.
    bool is_at(const std::filesystem::path& path) const;

private:
    int file_;
};

} // namespace placedpar::store
