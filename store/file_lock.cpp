#include "store/file_lock.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace placedpar::store {

FileLock::FileLock(const std::filesystem::path& path, const std::string& shown, const std::string& user)
    : file_(::open(path.c_str(), O_RDWR | O_CLOEXEC)) {
    if (file_ < 0)
        throw UserError(fmt::format("{}: the file cannot be opened: {}", shown, std::strerror(errno)));
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
        int reason = errno;
        ::close(file_);
        throw UserError(fmt::format("{}: {}", shown,
                                    reason == EWOULDBLOCK ? fmt::format("another {} is using the file", user)
                                                          : std::string(std::strerror(reason))));
    }
}

FileLock::~FileLock() { ::close(file_); }

std::string FileLock::beginning(std::size_t bytes) const {
    std::string text(bytes, '\0');
    ssize_t count = ::pread(file_, text.data(), text.size(), 0);
    text.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
    return text;
}

std::size_t FileLock::size() const {
    struct stat status {};
    ::fstat(file_, &status);
    return static_cast<std::size_t>(status.st_size);
}

bool FileLock::is_at(const std::filesystem::path& path) const {
    struct stat mine {
    }, there{};
    return ::fstat(file_, &mine) == 0 && ::stat(path.c_str(), &there) == 0 && mine.st_dev == there.st_dev &&
           mine.st_ino == there.st_ino;
}

} // namespace placedpar::store
