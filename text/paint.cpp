#include "text/paint.hpp"

#include "text/utf8.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <random>

namespace placedpar {

namespace {

/// These variables tell whether output is coloured. They are set before anything is printed, and only read afterwards.
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

/// Returns the mark that painted() writes where a colour begins or ends. escaped_but_paint() replaces the mark by a
/// control sequence. The mark is random in each run, so that no text from users can contain it.
const std::string& mark() {
    static const std::string drawn = [] {
        std::random_device device;
        return fmt::format("\033{:08x}{:08x}{:08x}[", device(), device(), device());
    }();
    return drawn;
}

/// Calls `take` with each piece of the text between marks, and `at_mark` at each mark. If nothing is painted, there are
/// no marks to look for.
template <class Take, class AtMark>
void between_marks(std::string_view text, Take take, AtMark at_mark) {
    std::size_t next = std::string_view::npos;
    while ((errors_painted || output_painted) && (next = text.find(mark())) != std::string_view::npos) {
        take(text.substr(0, next));
        at_mark();
        text.remove_prefix(next + mark().size());
    }
    take(text);
}

/// Escapes the text, but keeps its newlines.
std::string escaped_lines(std::string_view text) {
    std::string result;
    for (std::size_t end; (end = text.find('\n')) != std::string_view::npos; text.remove_prefix(end + 1))
        result += escaped(text.substr(0, end)) + "\n";
    return result + escaped(text);
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
    return fmt::format("{}{}{}m{}{}0m{}", text.substr(0, first), mark(), rendition(paint),
                       text.substr(first, last + 1 - first), mark(), text.substr(last + 1));
}

std::string escaped_but_paint(std::string_view text) {
    std::string result;
    between_marks(
        text, [&](std::string_view part) { result += escaped_lines(part); }, [&] { result += "\033["; });
    return result;
}

std::string unpainted(std::string_view text) {
    std::string result;
    bool painted = false; // a mark is followed by the rendition's parameters and an m
    auto take = [&](std::string_view part) { result += part.substr(painted ? part.find('m') + 1 : 0); };
    between_marks(text, take, [&] { painted = true; });
    return result;
}

} // namespace placedpar
