#pragma once

#include <filesystem>
#include <string_view>
#include <utility>

namespace placedpar::iserver {

/// Owns a file's descriptor, and closes it at the end. A negative number means no file.
class OpenFile {
public:
    OpenFile() = default;
    explicit OpenFile(int descriptor) : descriptor_(descriptor) {}
    ~OpenFile();
    OpenFile(OpenFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    OpenFile& operator=(OpenFile&& other) noexcept;

    int descriptor() const { return descriptor_; }
    explicit operator bool() const { return descriptor_ >= 0; }

private:
    int descriptor_ = -1;
};

/// The modes of fopen(), with their numbers in the iserver protocol.
enum class OpenMode { read = 1, write, append, update, write_and_read, append_and_read };

/// The only folder whose files a transputer program can reach on its host, this computer. The program is not trusted. A
/// name is a path below the folder, of at most 255 bytes. These names are refused: absolute names, names with "..", a
/// drive letter or a control character, names of folders and empty names. No symbolic link is followed in any part of a
/// name.
///
/// Each part of a name is opened relative to the descriptor of the folder before it. To check the beginning of a
/// resolved path would not be safe, because another program could replace a folder by a link after the check.
class HostFolder {
public:
    static constexpr std::size_t longest_name = 255; ///< bytes

    /// Makes an object without a folder, with which every call fails.
    HostFolder() = default;
    /// Throws UserError if the folder cannot be opened.
    explicit HostFolder(const std::filesystem::path&);

    /// Opens a regular file; devices and pipes are refused. The result has no file if this fails. Sets `created` to
    /// whether the file is new.
    OpenFile open(std::string_view name, OpenMode, bool& created) const;
    /// Removes a regular file. Returns whether this succeeded.
    bool remove(std::string_view name) const;
    /// Renames a regular file, and replaces a regular file that has the new name. Returns whether this succeeded.
    bool rename(std::string_view from, std::string_view to) const;

private:
    OpenFile folder_;
};

} // namespace placedpar::iserver
