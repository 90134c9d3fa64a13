#include "app/standard_error.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <cstdio>

namespace placedpar {

void print_warnings(const std::string& warnings) { fmt::print(stderr, "{}", warnings); }

Progress::Progress() : terminal_(::isatty(STDERR_FILENO)) {}

void Progress::show(const std::string& what) {
    if (terminal_ && what != shown_) {
        shown_ = what;
        fmt::print(stderr, "\r\033[K{} ...", what);
        std::fflush(stderr);
    }
}

void Progress::clear() {
    if (terminal_)
        fmt::print(stderr, "\r\033[K");
}

} // namespace placedpar
