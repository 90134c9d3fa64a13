#pragma once

#include <filesystem>

namespace placedpar {

/// A file that is written in the destination's folder and then replaces the destination. Until then the file has no
/// name, if the file system supports this, so nothing is left even if the program is killed. Otherwise its name is the
/// destination's name followed by the process number and ".part".
class TemporaryFile {
public:
    /// Creates the file with the usual permissions of a new file. If this fails, errno has the reason.
    explicit TemporaryFile(const std::filesystem::path& destination);
    /// Removes the file unless it has replaced the destination.
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// Returns the file's descriptor; below 0 if the file could not be opened.
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
