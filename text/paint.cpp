#include "text/paint.hpp"

#include "text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

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

constexpr std::string_view paint_begins = "\033[", paint_ends = "\033[0m";

/// How many bytes of paint the text begins with, where any may be there.
std::size_t paint_at(std::string_view text) {
    if (!(errors_painted || output_painted) || !text.starts_with(paint_begins))
        return 0;
    if (text.starts_with(paint_ends))
        return paint_ends.size();
    for (int paint = 0; paint <= static_cast<int>(Paint::failure); ++paint) {
        const std::string_view known = rendition(static_cast<Paint>(paint));
        if (text.substr(paint_begins.size()).starts_with(known) &&
            text.substr(paint_begins.size() + known.size()).starts_with('m'))
            return paint_begins.size() + known.size() + 1;
    }
    return 0;
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
    return fmt::format("{}{}{}m{}{}{}", text.substr(0, first), paint_begins, rendition(paint),
                       text.substr(first, last + 1 - first), paint_ends, text.substr(last + 1));
}

std::string escaped_but_paint(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t kept = text.front() == '\n' ? 1 : paint_at(text);
        const std::size_t end = kept > 0 ? kept : std::min(text.find_first_of("\n\033", 1), text.size());
        result += kept > 0 ? std::string(text.substr(0, kept)) : escaped(text.substr(0, end));
        text.remove_prefix(end);
    }
    return result;
}

} // namespace placedpar
