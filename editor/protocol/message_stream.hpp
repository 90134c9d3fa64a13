#pragma once

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace placedpar::editor {

inline constexpr std::size_t largest_message_bytes = std::size_t{64} << 20;

/// Reports that the header of a message does not state the message's length.
struct BadHeader : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Reads and writes the messages between an editor and a language server. Each message has a header with
/// `Content-Length: N`, an empty line, and N bytes.
class MessageStream {
public:
    /// REQUIRES: the streams outlive this object.
    MessageStream(std::istream& in, std::ostream& out) : in_(in), out_(out) {}

    /// Returns the next message; nothing at the end of the input. After a BadHeader, the next call continues with the
    /// next header.
    std::optional<std::string> read();
    /// Returns whether more input has arrived already.
    bool has_more() const;
    void write(std::string_view message);

private:
    std::optional<std::string> read_line();

    std::istream& in_;
    std::ostream& out_;
};

} // namespace placedpar::editor
