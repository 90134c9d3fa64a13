#include "app/standard_error.hpp"

#include "text/output_file.hpp"

#include <unistd.h>

namespace placedpar {

void print_warnings(const std::string& warnings) { print_error(warnings); }

ProgressLine::ProgressLine() : terminal_(::isatty(STDERR_FILENO)) {}

void ProgressLine::show(const std::string& what) {
    if (terminal_ && what != shown_) {
        shown_ = what;
        print_error(what + " ...", "\r\033[K");
    }
}

void ProgressLine::clear() {
    if (terminal_)
        print_error("", "\r\033[K");
}

} // namespace placedpar
