#include "iserver/terminal.hpp"

#include "text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

namespace placedpar::iserver {

namespace {

constexpr std::size_t longest_sequence = 24; ///< bytes; a sequence that sets the colours of foreground and background
                                             ///< takes 19

enum class Piece { whole, begun, wrong };

bool is_plain(char c) {
    return (c >= ' ' && c <= '~') || std::string_view("\n\r\t\b\a").find(c) != std::string_view::npos;
}

/// Classifies the bytes of an escape sequence: `ESC [`, numbers with semicolons, and a letter.
Piece sequence_of(std::string_view bytes) {
    if (bytes.size() == 1)
        return Piece::begun;
    const std::size_t last = std::min(bytes.find_first_not_of("0123456789;", 2), bytes.size());
    if (bytes[1] != '[' || bytes.size() > longest_sequence)
        return Piece::wrong;
    if (last == bytes.size())
        return Piece::begun;
    return std::string_view("ABCDEFGHJKdfmsu").find(bytes[last]) != std::string_view::npos ? Piece::whole
                                                                                           : Piece::wrong;
}

/// Classifies the bytes of a character of UTF-8 that is not ASCII. Control characters, from 0x80 to 0x9f, are wrong.
Piece character_of(std::string_view bytes) {
    const Utf8Character character = first_character(bytes);
    if (character.bytes > 0)
        return character.code >= 0xa0 ? Piece::whole : Piece::wrong;
    const auto announced = static_cast<std::size_t>(std::countl_one(static_cast<unsigned char>(bytes.front())));
    const bool continued = std::ranges::all_of(bytes.substr(1), [](char c) { return (c & 0xc0) == 0x80; });
    return continued && bytes.size() < announced && announced <= 4 ? Piece::begun : Piece::wrong;
}

Piece piece_of(std::string_view bytes) {
    const char first = bytes.front();
    if (is_plain(first))
        return Piece::whole;
    if (first == '\x1b')
        return sequence_of(bytes);
    return static_cast<unsigned char>(first) >= 0x80 ? character_of(bytes) : Piece::wrong;
}

std::string shown_byte(char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x80 ? fmt::format("^{}", static_cast<char>(code ^ 0x40)) : fmt::format("\\x{:02x}", code);
}

} // namespace

std::optional<std::uint8_t> ScriptedTerminal::pressed_key() {
    if (at_end())
        return std::nullopt;
    return static_cast<std::uint8_t>(keys_[used_++]);
}

std::string ScriptedTerminal::line() {
    const std::size_t newline = keys_.find('\n', used_);
    const std::size_t end = newline == keys_.npos ? keys_.size() : newline + 1;
    std::string line = keys_.substr(used_, end - used_);
    used_ = end;
    return line;
}

std::string VisibleText::next(std::string_view bytes) {
    const std::string text = begun_ + std::string(bytes);
    std::string_view rest = text;
    std::string shown;
    while (!rest.empty()) {
        std::size_t size = 1;
        Piece piece = piece_of(rest.substr(0, size));
        while (piece == Piece::begun && size < rest.size())
            piece = piece_of(rest.substr(0, ++size));
        if (piece == Piece::begun)
            break;
        if (piece == Piece::wrong)
            size = 1;
        coloured_ = coloured_ || (piece == Piece::whole && rest[0] == '\x1b' && rest[size - 1] == 'm');
        shown += piece == Piece::whole ? std::string(rest.substr(0, size)) : shown_byte(rest[0]);
        rest.remove_prefix(size);
    }
    begun_ = rest;
    return shown;
}

std::string VisibleText::end() {
    std::string shown;
    for (char byte : begun_)
        shown += is_plain(byte) ? std::string(1, byte) : shown_byte(byte);
    begun_.clear();
    if (std::exchange(coloured_, false))
        shown += "\x1b[0m";
    return shown;
}

} // namespace placedpar::iserver
