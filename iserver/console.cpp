#include "iserver/console.hpp"

#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace placedpar::iserver {

namespace {

constexpr int look_every_ms = 100; ///< interval at which a wait checks for an interruption

} // namespace

bool write_to_screen(std::string_view text) {
    const int output = standard_output_takes_a_file() ? STDERR_FILENO : STDOUT_FILENO;
    while (!text.empty()) {
        const ssize_t count = ::write(output, text.data(), text.size());
        if (count < 0 && errno == EPIPE)
            return false;
        if (count < 0 && errno != EINTR && errno != EAGAIN)
            throw UserError(
                fmt::format("the program's output cannot be written: {}", std::generic_category().message(errno)));
        text.remove_prefix(count < 0 ? 0 : static_cast<std::size_t>(count));
    }
    return true;
}

Console::Console(std::function<bool()> interrupted, int input, std::function<void()> unread)
    : interrupted_(std::move(interrupted)), unread_(std::move(unread)), input_(input),
      is_terminal_(::isatty(input) != 0 && ::tcgetattr(input, &found_) == 0) {}

Console::~Console() { set_mode(Mode::as_found); }

void Console::set_mode(Mode mode) {
    if (!is_terminal_ || mode == std::exchange(mode_, mode))
        return;
    termios settings = found_;
    if (mode == Mode::keys) {
        settings.c_iflag &= ~static_cast<tcflag_t>(ICRNL);
        settings.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
        settings.c_cc[VMIN] = 1;
        settings.c_cc[VTIME] = 0;
    }
    ::tcsetattr(input_, TCSANOW, &settings);
}

/// Reads bytes that have been typed; if `waits` is true, first waits for some. An error counts as the end of the input.
/// For example, a program in the background cannot read from the terminal.
void Console::read_more(bool waits) {
    pollfd source{.fd = input_, .events = POLLIN, .revents = 0};
    int ready = 0;
    do
        ready = ::poll(&source, 1, waits ? look_every_ms : 0);
    while (waits && ready <= 0 && !interrupted_());
    if (ready <= 0) {
        ended_ = ended_ || waits;
        return;
    }
    std::array<char, 512> bytes;
    const ssize_t count = ::read(input_, bytes.data(), bytes.size());
    ended_ = ended_ || count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR);
    read_.append(bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
}

std::optional<std::uint8_t> Console::next_key() {
    if (read_.empty())
        return std::nullopt;
    const std::size_t line_end = is_terminal_ ? 0 : read_.starts_with("\r\n") ? 2 : read_.starts_with('\n') ? 1 : 0;
    const char key = line_end > 0 ? '\r' : read_.front();
    read_.erase(0, std::max(line_end, std::size_t{1}));
    return static_cast<std::uint8_t>(key);
}

std::optional<std::uint8_t> Console::wait_for_key() {
    set_mode(Mode::keys);
    while (read_.empty() && !ended_)
        read_more(true);
    return next_key();
}

std::optional<std::uint8_t> Console::pressed_key() {
    set_mode(Mode::keys);
    if (read_.empty() && !ended_)
        read_more(false);
    return next_key();
}

std::string Console::line() {
    if (mode_ == Mode::keys && is_terminal_) { // in keys that were typed before this call, Enter is 13
        read_more(false);
        std::ranges::replace(read_, '\r', '\n');
    }
    set_mode(Mode::as_found);
    while (read_.find('\n') == std::string::npos && !ended_)
        read_more(true);
    const std::size_t newline = read_.find('\n');
    std::string line = read_.substr(0, newline == std::string::npos ? newline : newline + 1);
    read_.erase(0, line.size());
    return line;
}

} // namespace placedpar::iserver
