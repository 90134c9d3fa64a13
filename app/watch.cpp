#include "app/watch.hpp"

#include "app/live_curve.hpp"
#include "text/output_file.hpp"

#include <fmt/format.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace placedpar {

namespace {

struct Screen {
    std::size_t columns = 80, rows = 24;
};

/// Returns the terminal's present size, or a usual size if the terminal does not report its size.
Screen screen_size() {
    winsize size{};
    Screen screen;
    if (::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0)
        screen = {size.ws_col, size.ws_row};
    return {std::max<std::size_t>(screen.columns, 25), screen.rows};
}

bool can_be_drawn_on() {
    const char* kind = std::getenv("TERM");
    return ::isatty(STDERR_FILENO) != 0 && kind && std::string_view(kind) != "dumb";
}

/// Returns the next of 1, 2, 5, 10, 20, 50 and so on.
std::size_t milestone_after(std::size_t milestone) {
    std::size_t decade = 1;
    while (decade * 10 <= milestone)
        decade *= 10;
    return milestone == 2 * decade ? 5 * decade : milestone == 5 * decade ? 10 * decade : 2 * decade;
}

} // namespace

Watch::Watch(GenerationLog& log, std::string heading)
    : log_(log), heading_(std::move(heading)), terminal_(can_be_drawn_on()) {}

void Watch::observe(const ObservedGeneration& generation) {
    log_.observe(generation);
    if (!terminal_)
        return say_milestone();
    if (Clock::now() - drawn_ >= std::chrono::milliseconds(100))
        draw();
}

void Watch::say_milestone() {
    std::size_t made = (log_.compares() ? log_.of_all() : log_.of(0)).size();
    if (made < next_milestone_)
        return;
    next_milestone_ = milestone_after(next_milestone_);
    said_ = state_of(log_);
    print_error(fmt::format("{}, {}\n", heading_, said_));
}

void Watch::draw() {
    Screen screen = screen_size();
    std::size_t rows = std::clamp<std::size_t>(screen.rows, 8, 19) - 6;
    auto lines = live_curve(log_, screen.columns - 1, rows);
    lines.insert(lines.begin(), heading_.substr(0, screen.columns - 1));
    std::string out;
    for (const std::string& line : lines)
        out += line + "\n";
    print_error(out, lines_ > 0 ? fmt::format("\r\033[{}A\033[J", lines_) : "");
    lines_ = lines.size();
    drawn_ = Clock::now();
}

void Watch::finish() {
    if (terminal_)
        draw();
    else if (std::string last = state_of(log_); !last.empty() && last != said_)
        print_error(fmt::format("{}, {}\n", heading_, last));
}

} // namespace placedpar
