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

constexpr mode_t as_any_file = 0666; // less what the umask takes away

fs::path name_beside(const fs::path& path) {
    fs::path name = path;
    name += fmt::format(".{}.part", ::getpid());
    return name;
}

/// The only name of a file that has no other.
std::string name_of_open(int file) { return fmt::format("/proc/self/fd/{}", file); }

/// Below 0 where the file system has no such files, or where there is no /proc to name them by.
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

/// A link takes no other file's place, a renaming does.
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
    std::remove(name.c_str()); // of a program of the same number that was killed just here
    if (!give_name(file_, name))
        return false;
    name_ = std::move(name);
    return true;
}

} // namespace placedpar
