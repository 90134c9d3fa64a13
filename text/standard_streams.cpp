#include "text/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace placedpar {

namespace {

bool gives_it_to_a_file = false; // a global variable, since there is one standard output

} // namespace

bool is_standard_stream(const std::filesystem::path& path) { return path == "-"; }

std::string shown_input(const std::filesystem::path& path) {
    return is_standard_stream(path) ? "<standard input>" : path.string();
}

std::string shown_output(const std::filesystem::path& path) {
    return is_standard_stream(path) ? "<standard output>" : path.string();
}

void give_standard_output_to_a_file() { gives_it_to_a_file = true; }

void hold_closed_streams() {
    // open() returns the lowest free descriptor.
    for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0)
            static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

bool standard_output_takes_a_file() { return gives_it_to_a_file; }

} // namespace placedpar
