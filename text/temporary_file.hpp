#pragma once

#include <filesystem>

namespace placedpar {

/// What is written before it takes the place of a file, in the same folder. Where the file system has files without a
/// name it has none until then, so that nothing is left of it even when the program is killed; elsewhere it is called
/// as that file, with the number of the process and ".part" behind it.
class TemporaryFile {
public:
    /// With the permissions of any new file. errno says why it could not be opened, if so.
    explicit TemporaryFile(const std::filesystem::path& destination);
    /// Removes the file, unless it has taken its place.
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// Returns the file's descriptor; below 0 if the file could not be opened.
    int descriptor() const { return file_; }
    /// At once, whether a file is there or not. False if it cannot; errno says why. REQUIRES: it is open; called once.
    bool take_place();

private:
    bool take_name();

    std::filesystem::path destination_;
    std::filesystem::path name_; ///< "": none
    int file_;
};

} // namespace placedpar
