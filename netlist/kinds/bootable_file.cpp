#include "netlist/kinds/bootable_file.hpp"

#include "text/counted.hpp"
#include "text/load_source.hpp"
#include "text/user_error.hpp"
#include "text/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>

namespace placedpar {

namespace {

bool begins_with(std::span<const std::uint8_t> bytes, std::string_view text) {
    return bytes.size() >= text.size() &&
           std::equal(text.begin(), text.end(), bytes.begin(),
                      [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

bool is_control(char32_t code) {
    return code == 0x7f ||
           (code < ' ' && code != '\t' && code != '\n' && code != '\r' && code != 26); // 26 ends DOS files
}

/// Returns whether the first bytes are text. Text has no control characters. At most one byte in 8 may be outside
/// UTF-8, since old files use other encodings.
bool is_text(std::span<const std::uint8_t> bytes) {
    const auto begin = bytes.first(std::min<std::size_t>(bytes.size(), 512));
    std::string_view rest(reinterpret_cast<const char*>(begin.data()), begin.size());
    std::size_t strange = 0;
    while (!rest.empty()) {
        const Utf8Character next = first_character(rest);
        if (next.bytes == 0)
            ++strange;
        else if (is_control(next.code))
            return false;
        rest.remove_prefix(std::max<std::size_t>(next.bytes, 1));
    }
    return 8 * strange <= begin.size();
}

/// Returns whether the file is in INMOS's format for object files, and begins with a record of this tag. The tag tells
/// an object file, a linked unit and a library apart.
bool is_object(std::span<const std::uint8_t> bytes, std::uint8_t tag) {
    return bytes.size() > 8 && bytes[0] == tag && bytes[1] == 0 && bytes[2] == 2 && bytes[4] == 0xfd;
}

std::vector<std::uint8_t> read_bytes(const std::filesystem::path& path) {
    if (std::string why = why_not_a_file(path); !why.empty())
        throw UserError(fmt::format("{}: {}", path.string(), why));
    std::ifstream file(path, std::ios::binary);
    std::vector<std::uint8_t> bytes;
    std::vector<char> some(65536);
    while (file.read(some.data(), static_cast<std::streamsize>(some.size())) || file.gcount() > 0) {
        bytes.insert(bytes.end(), some.begin(), some.begin() + file.gcount());
        if (bytes.size() > largest_bootable_bytes)
            throw UserError(fmt::format("{}: the file is larger than 64 Mbyte", path.string()));
    }
    return bytes;
}

} // namespace

std::string why_not_bootable(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view library = "\x01\x00\x16\x00";
    if (bytes.empty())
        return "the file is empty";
    if (is_object(bytes, 0x01))
        return "this is an object file of a compiler; ilink links it, and icollect makes a bootable file of the result";
    if (is_object(bytes, 0x1c))
        return "this is a linked unit; icollect makes a bootable file of it";
    if (begins_with(bytes, std::string_view(library.data(), 4)))
        return "this is a library of object files";
    if (begins_with(bytes, "\x07"
                           "CFB"))
        return "this is the output of a configurer; icollect makes a bootable file of it";
    if (begins_with(bytes, "MZ") || begins_with(bytes, "\x7f"
                                                       "ELF"))
        return "this is a program for the host computer, not for a transputer";
    if (is_text(bytes))
        return "this is text, not code for a transputer";
    if (bytes[0] >= 2 && bytes.size() <= bytes[0])
        return fmt::format("the file is cut off: its first byte announces a loader of {}, but the file ends after {}",
                           counted(bytes[0], "byte"), counted(bytes.size() - 1, "byte"));
    return "";
}

bool looks_bootable(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        return false;
    std::ifstream file(path, std::ios::binary);
    std::vector<char> begin(512);
    file.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    const std::vector<std::uint8_t> bytes(begin.begin(), begin.begin() + file.gcount());
    return !bytes.empty() && !is_text(bytes);
}

std::vector<std::uint8_t> read_bootable(const std::filesystem::path& path) {
    std::vector<std::uint8_t> bytes = read_bytes(path);
    if (std::string why = why_not_bootable(bytes); !why.empty())
        throw UserError(fmt::format("{}: {}", path.string(), why));
    return bytes;
}

} // namespace placedpar
