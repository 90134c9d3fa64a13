#include "text/positions.hpp"

#include "text/utf8.hpp"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <stdexcept>

namespace placedpar {

namespace {

struct CharacterSize {
    std::size_t bytes = 1, units = 1;
};

CharacterSize size_of(std::string_view rest) {
    if (static_cast<unsigned char>(rest.front()) < 0x80)
        return {};
    const Utf8Character character = first_character(rest);
    return {std::max<std::size_t>(character.bytes, 1), character.code > 0xffff ? 2U : 1U};
}

bool is_in_word(char c, bool with_dots) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x80 && std::isalnum(byte) != 0) || c == '_' || (with_dots && c == '.');
}

std::size_t length_of_word(std::string_view rest, bool with_dots) {
    if (rest.empty())
        return 0;
    if (rest.front() == '"')
        return std::min(rest.find('"', 1), rest.size() - 1) + 1;
    std::size_t length = 0;
    while (length < rest.size() && is_in_word(rest[length], with_dots))
        ++length;
    while (length > 0 && rest[length - 1] == '.') // a dot at the end belongs to the text after it
        --length;
    return length > 0 ? length : size_of(rest).bytes;
}

} // namespace

Positions::Positions(std::string_view text) : text_(text), starts_{0} {
    for (std::size_t next = 1; next <= text.size(); ++next) {
        const char end = text[next - 1];
        if (end == '\n' || (end == '\r' && (next == text.size() || text[next] != '\n')))
            starts_.push_back(next);
    }
}

std::size_t Positions::offset(Position position) const {
    if (position.line == lines())
        return text_.size();
    if (position.line > lines())
        throw std::out_of_range("the line is after the end of the text");
    std::size_t at = starts_[position.line];
    for (std::size_t units = 0; at < text_.size() && text_[at] != '\n' && text_[at] != '\r';) {
        const CharacterSize size = size_of(text_.substr(at));
        if (units + size.units > position.character)
            break;
        units += size.units;
        at += size.bytes;
    }
    return at;
}

Position Positions::position(std::size_t offset) const {
    offset = std::min(offset, text_.size());
    const auto line = std::prev(std::ranges::upper_bound(starts_, offset));
    Position found{static_cast<std::size_t>(line - starts_.begin()), 0};
    for (std::size_t at = *line; at < offset;) {
        const CharacterSize size = size_of(text_.substr(at));
        found.character += size.units;
        at += size.bytes;
    }
    return found;
}

std::size_t offset_of(const Location& at) {
    const std::string_view line = at.file->line(at.line);
    if (line.data() == nullptr) // after the last line, or before the first
        return at.line == 0 ? 0 : at.file->text().size();
    return static_cast<std::size_t>(line.data() - at.file->text().data()) +
           std::min(std::max<std::size_t>(at.column, 1) - 1, line.size());
}

Location end_of_word(const Location& at, NamesOf language) {
    if (!at.file || at.line == 0 || at.column == 0)
        return at;
    const std::string_view line = at.file->line(at.line);
    const std::string_view rest = line.substr(std::min(at.column - 1, line.size()));
    return {at.file, at.line, at.column + length_of_word(rest, language == NamesOf::occam)};
}

} // namespace placedpar
