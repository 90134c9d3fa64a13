#include "text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

namespace placedpar {

namespace {

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }

/// Returns how many bytes a character has, as its first byte shows. Returns 0 if no character begins with this byte.
std::size_t bytes_announced(unsigned char first) {
    auto ones = static_cast<std::size_t>(std::countl_one(first));
    return ones == 0 ? 1 : ones >= 2 && ones <= 4 ? ones : 0;
}

bool is_control(char32_t code) { return code != '\t' && (code < 0x20 || (code >= 0x7f && code < 0xa0)); }

std::string escaped_bytes(std::string_view bytes) {
    std::string result;
    for (char c : bytes)
        result += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    return result;
}

} // namespace

Utf8Character first_character(std::string_view text) {
    static constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800,
                                                   0x10000}; // the lowest code that takes this number of bytes
    auto first = text.empty() ? 0xff : static_cast<unsigned char>(text.front());
    auto bytes = bytes_announced(static_cast<unsigned char>(first));
    if (bytes == 0 || bytes > text.size() || !std::ranges::all_of(text.substr(1, bytes - 1), continues_character))
        return {};
    auto code = static_cast<char32_t>(bytes == 1 ? first : first & (0x7f >> bytes));
    for (char c : text.substr(1, bytes - 1))
        code = code << 6 | (static_cast<unsigned char>(c) & 0x3f);
    bool good = code >= least[bytes] && code <= 0x10ffff && !(code >= 0xd800 && code < 0xe000);
    return good ? Utf8Character{code, bytes} : Utf8Character{};
}

std::string as_utf8(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        auto bytes = first_character(text).bytes;
        auto latin = static_cast<unsigned char>(text[0]);
        if (bytes > 0)
            result += text.substr(0, bytes);
        else
            result.append({static_cast<char>(0xc0 | (latin >> 6)), static_cast<char>(0x80 | (latin & 0x3f))});
        text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    return result;
}

namespace {

/// Returns the text in UTF-8. If `word` returns a text for a character, this text replaces the character.
template <class Word>
std::string reworded(std::string_view text, Word word) {
    const std::string utf8 = as_utf8(text);
    std::string result;
    auto is_plain = [](char each) {
        return each >= ' ' && each <= '~' && std::string_view("<>&\"").find(each) == std::string_view::npos;
    };
    for (std::size_t at = 0; at < utf8.size();) {
        const auto plain = std::find_if_not(utf8.begin() + static_cast<std::ptrdiff_t>(at), utf8.end(), is_plain);
        const auto end = static_cast<std::size_t>(plain - utf8.begin());
        result.append(utf8, at, end - at);
        at = end;
        if (at == utf8.size())
            break;
        auto [code, bytes] = first_character(std::string_view(utf8).substr(at));
        const std::string instead = word(code);
        result += instead.empty() ? utf8.substr(at, bytes) : instead;
        at += bytes;
    }
    return result;
}

} // namespace

std::string as_markup(std::string_view text) {
    return reworded(text, [](char32_t code) -> std::string {
        switch (code) {
        case '<': return "&lt;";
        case '>': return "&gt;";
        case '&': return "&amp;";
        case '"': return "&quot;";
        default: return is_control(code) || code == '\t' || code == 0xfffe || code == 0xffff ? "?" : "";
        }
    });
}

std::string as_json(std::string_view json) {
    return reworded(json, [](char32_t code) {
        return is_control(code) && code != '\n' ? fmt::format("\\u{:04x}", static_cast<unsigned>(code)) : "";
    });
}

std::string escaped(std::string_view text) {
    if (std::ranges::all_of(text, [](char c) { return (c >= ' ' && c <= '~') || c == '\t'; }))
        return std::string(text);
    std::string result;
    while (!text.empty()) {
        auto [code, bytes] = first_character(text);
        auto piece = text.substr(0, std::max<std::size_t>(bytes, 1));
        result += bytes == 0 || is_control(code) ? escaped_bytes(piece) : std::string(piece);
        text.remove_prefix(piece.size());
    }
    return result;
}

} // namespace placedpar
