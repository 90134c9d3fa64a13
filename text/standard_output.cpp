#include "text/output_file.hpp"
#include "text/paint.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>

namespace placedpar {

namespace {

bool write_to(std::FILE* stream, std::string_view text) {
    return std::fwrite(text.data(), 1, text.size(), stream) == text.size() && std::fflush(stream) == 0;
}

} // namespace

void print_out(std::string_view text) {
    if (standard_output_takes_a_file())
        return print_error(text);
    if (!write_to(stdout, escaped_but_paint(text)) && errno != EPIPE)
        throw UserError(fmt::format("standard output cannot be written: {}", std::strerror(errno)));
}

void print_error(std::string_view text, std::string_view control) noexcept {
    try {
        write_to(stderr, std::string(control) + escaped_but_paint(text));
    } catch (const std::bad_alloc&) { // the text is lost, as it is on a full disk
    }
}

} // namespace placedpar
