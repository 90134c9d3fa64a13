#include "text/temporary_file.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <utility>

namespace placedpar {

namespace {

namespace fs = std::filesystem;

constexpr mode_t as_any_file = 0666; // permissions of a new file, before the umask

fs::path name_beside(const fs::path& path) {
    fs::path name = path;
    name += fmt::format(".{}.part", ::getpid());
    return name;
}

/// Returns the path under which Linux shows an open file that has no name.
std::string name_of_open(int file) { return fmt::format("/proc/self/fd/{}", file); }

/// Opens a file without a name. Returns a number below 0 if the file system does not support such files, or if the
/// folder /proc is missing.
int open_nameless(const fs::path& folder) {
    int file = ::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, as_any_file);
    if (file < 0 || ::access(name_of_open(file).c_str(), F_OK) == 0)
        return file;
    ::close(file);
    return -1;
}

bool give_name(int file, const fs::path& name) {
    return ::linkat(AT_FDCWD, name_of_open(file).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

} // namespace

TemporaryFile::TemporaryFile(const fs::path& destination)
    : destination_(destination), file_(open_nameless(destination.parent_path())) {
    if (file_ >= 0)
        return;
    name_ = name_beside(destination);
    file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, as_any_file);
}

TemporaryFile::~TemporaryFile() {
    if (file_ < 0)
        return;
    ::close(file_);
    if (!name_.empty())
        std::remove(name_.c_str());
}

/// If there is already a file at the destination, gives the new file a temporary name and renames it: link() cannot
/// replace a file, but rename() can.
bool TemporaryFile::take_place() {
    if (name_.empty() && give_name(file_, destination_))
        return true;
    if (name_.empty() && (errno != EEXIST || !take_name()))
        return false;
    if (std::rename(name_.c_str(), destination_.c_str()) != 0)
        return false;
    name_.clear();
    return true;
}

bool TemporaryFile::take_name() {
    fs::path name = name_beside(destination_);
    std::remove(name.c_str()); // left by a killed program that had the same process number
    if (!give_name(file_, name))
        return false;
    name_ = std::move(name);
    return true;
}

} // namespace placedpar
