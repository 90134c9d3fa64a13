#include "editor/protocol/message_stream.hpp"

#include "text/nearest.hpp"
#include "text/number.hpp"

#include <fmt/format.h>

#include <istream>
#include <ostream>

namespace placedpar::editor {

namespace {

constexpr std::string_view length_field = "content-length:";

/// Returns the length that a header line states. Ignores text before the field Content-Length, which may be the rest of
/// a malformed message.
std::optional<std::size_t> length_in(const std::string& line) {
    const auto field = lower_case(line).rfind(length_field);
    if (field == std::string::npos)
        return std::nullopt;
    const std::string_view value = std::string_view(line).substr(field + length_field.size());
    const auto first = value.find_first_not_of(' ');
    const auto length = parse_number<std::size_t>(value.substr(std::min(first, value.size())));
    if (!length || *length > largest_message_bytes)
        throw BadHeader(fmt::format("Content-Length must be a number of bytes up to {}", largest_message_bytes));
    return length;
}

} // namespace

/// Returns the next line without its line end; for a very long line, only its last part. Returns nothing at the end of
/// the input.
std::optional<std::string> MessageStream::read_line() {
    constexpr std::size_t longest = 4096;
    std::string line;
    char c = 0;
    while (in_.get(c) && c != '\n') {
        if (line.size() == longest)
            line.erase(0, longest / 2);
        line += c;
    }
    if (!in_)
        return std::nullopt;
    if (line.ends_with('\r'))
        line.pop_back();
    return line;
}

std::optional<std::string> MessageStream::read() {
    std::optional<std::size_t> length;
    bool has_fields = false;
    while (auto line = read_line()) {
        if (auto stated = length_in(*line))
            length = stated;
        has_fields |= !line->empty();
        if (!line->empty() || !has_fields)
            continue;
        if (!length)
            throw BadHeader("the header of the message has no Content-Length");
        std::string message(*length, '\0');
        in_.read(message.data(), static_cast<std::streamsize>(message.size()));
        return in_ ? std::optional(std::move(message)) : std::nullopt;
    }
    return std::nullopt;
}

bool MessageStream::has_more() const { return in_.rdbuf()->in_avail() > 0; }

void MessageStream::write(std::string_view message) {
    out_ << "Content-Length: " << message.size() << "\r\n\r\n" << message << std::flush;
}

} // namespace placedpar::editor
