#include "monitor/memory/file_lock.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace placedpar::monitor {

FileLock::FileLock(const std::filesystem::path& path) : file_(::open(path.c_str(), O_RDWR | O_CLOEXEC)) {
    if (file_ < 0)
        throw UserError(fmt::format("--state {}: cannot be opened: {}", path.string(), std::strerror(errno)));
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
        int reason = errno;
        ::close(file_);
        throw UserError(
            fmt::format("--state {}: {}", path.string(),
                        reason == EWOULDBLOCK ? "another placedpar monitor is using it" : std::strerror(reason)));
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

} // namespace placedpar::monitor
