#include "text/output_file.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace placedpar {

void print_out(std::string_view text) {
    std::FILE* out = standard_output_takes_a_file() ? stderr : stdout;
    if (std::fwrite(text.data(), 1, text.size(), out) == text.size() && std::fflush(out) == 0)
        return;
    if (errno != EPIPE)
        throw UserError(
            fmt::format("standard {} cannot be written: {}", out == stdout ? "output" : "error", std::strerror(errno)));
}

} // namespace placedpar
