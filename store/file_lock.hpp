#pragma once

#include <filesystem>
#include <string>

namespace placedpar::store {

/// A lock on a file that is there, whatever its names: symbolic and hard links lead to the same one. Goes with the
/// program, however that ends. SQLite's own locks are of another kind, so that both can be had.
class FileLock {
public:
    /// Throws UserError when another program has it, or the file cannot be opened to read and write. Messages call the
    /// file `shown`, and that program `user`: "placedpar monitor".
    FileLock(const std::filesystem::path& path, const std::string& shown, const std::string& user);
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    /// The file's first bytes, at most so many.
    std::string beginning(std::size_t bytes) const;
    std::size_t size() const;
    /// Does the path lead to the locked file still, rather than to another or to none?
    bool is_at(const std::filesystem::path& path) const;

private:
    int file_;
};

} // namespace placedpar::store
