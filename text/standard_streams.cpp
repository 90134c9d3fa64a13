#include "text/standard_streams.hpp"

#include "text/output_file.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace placedpar {

namespace {

bool standard_output_takes_a_file = false; // as standard output itself, it is the whole program's

} // namespace

bool is_standard_stream(const std::filesystem::path& path) { return path == "-"; }

std::string shown_input(const std::filesystem::path& path) {
    return is_standard_stream(path) ? "<standard input>" : path.string();
}

std::string shown_output(const std::filesystem::path& path) {
    return is_standard_stream(path) ? "<standard output>" : path.string();
}

void give_standard_output_to_a_file() { standard_output_takes_a_file = true; }

void print_out(std::string_view text) {
    std::FILE* out = standard_output_takes_a_file ? stderr : stdout;
    if (std::fwrite(text.data(), 1, text.size(), out) == text.size() && std::fflush(out) == 0)
        return;
    if (errno != EPIPE)
        throw UserError(
            fmt::format("standard {} cannot be written: {}", out == stdout ? "output" : "error", std::strerror(errno)));
}

} // namespace placedpar
