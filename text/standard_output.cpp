#include "text/output_file.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace placedpar {

void print_out(std::string_view text) {
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
        throw UserError(fmt::format("standard output cannot be written: {}", std::strerror(errno)));
}

} // namespace placedpar
