#pragma once

#include <filesystem>
#include <string>

namespace placedpar::store {

/// An exclusive lock on an existing file, which keeps two programs from using the file at the same time. All names of
/// the file, including symbolic and hard links, have the same lock. The system releases the lock when the program ends,
/// even by a crash. SQLite's own locks are independent of this lock.
class FileLock {
public:
    /// Takes the lock. Throws UserError if another program holds the lock, or if the file cannot be opened for reading
    /// and writing. Messages call the file `shown`, and the other program `user`, such as "placedpar monitor".
    FileLock(const std::filesystem::path& path, const std::string& shown, const std::string& user);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    /// Returns the first bytes of the file; fewer than `bytes` if the file is shorter.
    std::string beginning(std::size_t bytes) const;
    std::size_t size() const;
    /// Returns whether the path still refers to the locked file.
    bool is_at(const std::filesystem::path& path) const;

private:
    int file_;
};

} // namespace placedpar::store
