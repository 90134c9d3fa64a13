#include "iserver/packet.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar::iserver {

std::size_t PacketReader::wanted() const {
    if (!refusal_.empty())
        return 0;
    return (held_ < 2 ? 2 : 2 + length()) - held_;
}

ByteView PacketReader::take(ByteView& bytes) {
    while (!bytes.empty() && wanted() > 0) {
        const std::size_t part = std::min(wanted(), bytes.size());
        std::ranges::copy(bytes.first(part), packet_.begin() + static_cast<std::ptrdiff_t>(held_));
        bytes = bytes.subspan(part);
        held_ += part;
        if (held_ == 2)
            check_length();
        if (wanted() > 0 || !refusal_.empty())
            continue;
        held_ = 0;
        ++complete_;
        return ByteView(packet_).subspan(2, length());
    }
    return {};
}

void PacketReader::check_length() {
    const std::size_t length = this->length();
    if (complete_ == 0 && length == 4) // AFserver sends words, and begins each integer with the word 4
        refusal_ = "the program's first request is of the older AFserver (alien file server) protocol; "
                   "only programs for iserver can be served";
    else if (length < shortest_data || length > longest_data || length % 2 != 0)
        refusal_ =
            fmt::format("request {} to the host has the length {}; a length must be even, and from {} to {}{}",
                        complete_ + 1, length, shortest_data, longest_data,
                        length > longest_data && length <= longest_of_later_servers && length % 2 == 0
                            ? ": the host serves version 1.0 of the protocol, which has no requests of this length"
                            : "");
}

ByteView RequestFields::front(std::size_t bytes) {
    if (bytes > rest_.size()) {
        good_ = false;
        return {};
    }
    ByteView field = rest_.first(bytes);
    rest_ = rest_.subspan(bytes);
    return field;
}

std::uint32_t RequestFields::number(std::size_t bytes) {
    std::uint32_t value = 0;
    std::uint32_t shift = 0;
    for (std::uint8_t each : front(bytes)) {
        value |= std::uint32_t{each} << shift;
        shift += 8;
    }
    return value;
}

std::string_view RequestFields::text() {
    ByteView bytes = front(count());
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Reply& Reply::number(std::uint32_t value, std::size_t bytes) {
    for (std::size_t byte = 0; byte < bytes; ++byte)
        packet_.push_back(static_cast<std::uint8_t>(value >> 8 * byte));
    return *this;
}

Reply& Reply::text(std::string_view text) {
    count(text.size());
    packet_.insert(packet_.end(), text.begin(), text.end());
    return *this;
}

Bytes Reply::packet() const {
    Bytes packet = packet_;
    const std::size_t length = std::max(packet.size() - 2, shortest_data);
    packet.resize(2 + length + length % 2);
    packet[0] = static_cast<std::uint8_t>(packet.size() - 2);
    packet[1] = static_cast<std::uint8_t>((packet.size() - 2) >> 8);
    return packet;
}

} // namespace placedpar::iserver
