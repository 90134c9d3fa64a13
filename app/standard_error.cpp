#include "app/standard_error.hpp"

#include "text/output_file.hpp"

#include <unistd.h>

namespace placedpar {

void print_warnings(const std::string& warnings) { print_error(warnings); }

Progress::Progress() : terminal_(::isatty(STDERR_FILENO)) {}

void Progress::show(const std::string& what) {
    if (terminal_ && what != shown_) {
        shown_ = what;
        print_error(what + " ...", "\r\033[K");
    }
}

void Progress::clear() {
    if (terminal_)
        print_error("", "\r\033[K");
}

} // namespace placedpar
