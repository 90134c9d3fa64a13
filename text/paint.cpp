#include "text/paint.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

/// Set before anything is printed, and only read from then on.
bool errors_painted = false, output_painted = false;

/// The parameters of ECMA-48's Select Graphic Rendition: 1 bold, 31 red, 32 green, 33 yellow, 36 cyan.
const char* rendition(Paint paint) {
    switch (paint) {
    case Paint::error: return "1;31";
    case Paint::warning: return "1;33";
    case Paint::note: return "1;36";
    case Paint::place: return "1";
    case Paint::caret: return "1;32";
    case Paint::heading: return "1";
    case Paint::success: return "32";
    case Paint::failure: return "1;31";
    }
    return "";
}

bool goes_to_output(Paint paint) {
    return paint == Paint::heading || paint == Paint::success || paint == Paint::failure;
}

} // namespace

void set_painted(PaintedStream stream, bool painted) {
    (stream == PaintedStream::errors ? errors_painted : output_painted) = painted;
}

std::string painted(Paint paint, std::string_view text) {
    std::size_t first = text.find_first_not_of(" \t\n"), last = text.find_last_not_of('\n');
    if (!(goes_to_output(paint) ? output_painted : errors_painted) || first == std::string_view::npos)
        return std::string(text);
    return fmt::format("{}\033[{}m{}\033[0m{}", text.substr(0, first), rendition(paint),
                       text.substr(first, last + 1 - first), text.substr(last + 1));
}

} // namespace placedpar
