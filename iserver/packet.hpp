#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar::iserver {

/// This header has the packets of the iserver protocol, by which a transputer program asks its host for files, the
/// terminal and the time. A packet is a length of 16 bits, and that number of bytes. A request has a tag and fields, a
/// reply has a result and fields. The low byte of a number comes first. A text is its length in 16 bits, then its
/// bytes.
using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

inline constexpr std::size_t shortest_data = 6;                     ///< bytes after a packet's length
inline constexpr std::size_t longest_data = 510;                    ///< bytes after a packet's length
inline constexpr std::size_t longest_of_later_servers = 1022;       ///< the value of longest_data for servers from
                                                                    ///< version 1.4 on
inline constexpr std::size_t longest_reply_text = longest_data - 3; ///< bytes; the result and the text's length take 3
                                                                    ///< more

enum class Result : std::uint8_t { success = 0, not_implemented = 1, failed = 129 };

/// Assembles requests from the bytes of a link, which come one by one or in parts.
class PacketReader {
public:
    /// Removes bytes from the front of `bytes`, at most up to the end of a request. Returns the request without its
    /// length if the request is complete now, otherwise an empty view. The view is valid until the next call. After a
    /// refusal, takes nothing.
    ByteView take(ByteView& bytes);
    /// Returns how many bytes the request still needs at least; 0 after a refusal.
    std::size_t wanted() const;
    /// Returns how many bytes of an incomplete request have come.
    std::size_t held() const { return held_; }
    /// Returns why a packet was refused; "" if none was. A packet is refused if its length is invalid. Its end is then
    /// unknown, so nothing after it can be read.
    const std::string& refusal() const { return refusal_; }

private:
    std::size_t length() const { return packet_[0] + 256U * packet_[1]; }
    void check_length();

    std::array<std::uint8_t, 2 + longest_data> packet_{};
    std::size_t held_ = 0;
    std::size_t complete_ = 0; ///< the number of complete requests
    std::string refusal_;
};

/// Reads the fields of a request, in order. For a field beyond the request's end, the result is 0 or "", and good()
/// becomes false.
class RequestFields {
public:
    /// The first field is the tag. REQUIRES: the request's bytes outlive this object and the results of text().
    explicit RequestFields(ByteView request) : rest_(request) {}

    std::uint8_t byte() { return static_cast<std::uint8_t>(number(1)); }
    std::uint16_t count() { return static_cast<std::uint16_t>(number(2)); }
    std::int32_t word() { return static_cast<std::int32_t>(number(4)); }
    std::string_view text();
    bool good() const { return good_; }

private:
    std::uint32_t number(std::size_t bytes);
    ByteView front(std::size_t bytes);

    ByteView rest_;
    bool good_ = true;
};

/// Collects the fields of a reply. REQUIRES: the result and all fields have at most longest_data bytes.
class Reply {
public:
    static Reply success_if(bool success) { return Reply(success ? Result::success : Result::failed); }
    explicit Reply(Result result) : packet_{0, 0, static_cast<std::uint8_t>(result)} {}
    Reply& byte(std::uint8_t value) { return number(value, 1); }
    Reply& count(std::size_t value) { return number(static_cast<std::uint32_t>(value), 2); }
    Reply& word(std::int32_t value) { return number(static_cast<std::uint32_t>(value), 4); }
    Reply& text(std::string_view);
    /// Returns the packet with its length. Zeros are added until the length is even and at least shortest_data.
    Bytes packet() const;

private:
    Reply& number(std::uint32_t value, std::size_t bytes);

    Bytes packet_;
};

} // namespace placedpar::iserver
