#pragma once

#include <filesystem>

namespace placedpar {

/// A new file in the folder of another file, the destination. When the new file is complete, it replaces the
/// destination in one step. Until then it has no name, if the file system supports this; nothing is then left if the
/// program is killed. On other file systems, its name is that of the destination followed by the process number and
/// ".part".
class TemporaryFile {
public:
    /// Creates the file with the usual permissions of a new file. If this fails, errno has the reason.
    explicit TemporaryFile(const std::filesystem::path& destination);
    /// Removes the file, if it has not replaced the destination.
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// Returns the descriptor of the file; below 0 if the file could not be created.
    int descriptor() const { return file_; }
    /// Replaces the destination, or creates it, in one step. Returns false if this fails; errno then has the reason.
    /// REQUIRES: the file is open; take_place() is called once.
    bool take_place();

private:
    bool take_name();

    std::filesystem::path destination_;
    std::filesystem::path name_; ///< "": the file has no name
    int file_;
};

} // namespace placedpar
