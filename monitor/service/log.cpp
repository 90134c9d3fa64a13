#include "monitor/service/log.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <system_error>

namespace placedpar::monitor {

namespace {

std::string log_line(std::string_view sentence) {
    return fmt::format("{:%Y-%m-%dT%H:%M:%S}Z placedpar monitor: {}\n", fmt::gmtime(std::time(nullptr)), sentence);
}

/// Returns whether PIPE_BUF bytes can be written without waiting.
bool has_room(int file) {
    pollfd poll{file, POLLOUT, 0};
    return file >= 0 && ::poll(&poll, 1, 0) == 1 && poll.revents == POLLOUT;
}

} // namespace

Log::Log(int file) : file_(file) {
    struct stat status {};
    std::error_code ignored;
    if (file_ >= 0 && ::fstat(file_, &status) == 0 && S_ISREG(status.st_mode) && status.st_nlink > 0)
        path_ = std::filesystem::read_symlink(fmt::format("/proc/self/fd/{}", file_), ignored).string();
}

bool Log::is_terminal() const { return ::isatty(file_) == 1; }

bool Log::write(const std::string& text) {
    std::size_t written = 0;
    while (written < text.size() && has_room(file_)) {
        ssize_t count = ::write(file_, text.data() + written, std::min<std::size_t>(text.size() - written, PIPE_BUF));
        if (count < 0 && errno != EINTR)
            break;
        written += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    }
    if (written > 0)
        rest_ = text.substr(written);
    return written > 0;
}

void Log::say(std::string_view sentence) {
    tick();
    if (left_out_ > 0 || !rest_.empty() || !write(log_line(sentence)))
        ++left_out_;
}

void Log::tick() {
    if (!rest_.empty())
        write(std::string(rest_));
    if (left_out_ > 0 && rest_.empty() &&
        write(log_line(fmt::format("{} line{} left out of the log, because it could not be written", left_out_,
                                   left_out_ == 1 ? " was" : "s were"))))
        left_out_ = 0;
}

void Log::reopen() {
    if (path_.empty())
        return say("SIGHUP: the log is not a file, so it was not reopened");
    int opened = ::open(path_.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
    if (opened < 0 || ::dup2(opened, file_) < 0)
        say(fmt::format("SIGHUP: {} cannot be reopened: {}", path_, std::strerror(errno)));
    else
        say("the log was reopened");
    if (opened >= 0)
        ::close(opened);
}

} // namespace placedpar::monitor
