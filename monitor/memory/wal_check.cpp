#include "monitor/memory/wal_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

namespace placedpar::monitor {

namespace {

// https://www.sqlite.org/fileformat2.html, section 4, "The Write-Ahead Log".
constexpr std::size_t header_bytes = 32, frame_header_bytes = 24;
constexpr std::uint32_t magic = 0x377f0682; ///< its last bit: checksums are of big-endian words

std::uint32_t big_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

/// Section 4.2, "Checksum Algorithm": of 32-bit words, two at a time.
struct WalChecksum {
    bool of_big_endian;
    std::uint32_t a = 0, b = 0;

    std::uint32_t word(std::string_view bytes, std::size_t at) const {
        std::uint32_t value = big_endian(bytes, at);
        return of_big_endian ? value : __builtin_bswap32(value);
    }
    void add(std::string_view bytes) {
        for (std::size_t at = 0; at + 8 <= bytes.size(); at += 8) {
            a += word(bytes, at) + b;
            b += word(bytes, at + 4) + a;
        }
    }
    bool is(std::string_view bytes, std::size_t at) const {
        return big_endian(bytes, at) == a && big_endian(bytes, at + 4) == b;
    }
};

/// A log that was read whole.
class Wal {
public:
    explicit Wal(std::string text) : text_(std::move(text)) {}

    bool has_header() const {
        WalChecksum sum = checksum();
        sum.add(header().substr(0, 24));
        return (big_endian(text_, 0) | 1) == (magic | 1) && page_bytes() >= 512 && page_bytes() <= 65536 &&
               sum.is(text_, 24);
    }
    std::size_t frames() const { return (text_.size() - header_bytes) / frame_bytes(); }
    /// Up to the first whose checksum or salts are wrong.
    std::size_t good_frames() const {
        WalChecksum sum = checksum();
        sum.add(header().substr(0, 24));
        std::size_t good = 0;
        for (; good < frames(); ++good) {
            std::string_view each = frame(good);
            sum.add(each.substr(0, 8));
            sum.add(each.substr(frame_header_bytes));
            if (each.substr(8, 8) != header().substr(16, 8) || !sum.is(each, 16))
                break;
        }
        return good;
    }
    bool ends_transaction(std::size_t index) const { return big_endian(frame(index), 4) != 0; }
    /// Rather than being left over from the log before it, whose two salts were both others.
    bool is_of_this_log(std::size_t index) const {
        return frame(index).substr(8, 4) == header().substr(16, 4) ||
               frame(index).substr(12, 4) == header().substr(20, 4);
    }

private:
    std::string_view header() const { return std::string_view(text_).substr(0, header_bytes); }
    std::size_t page_bytes() const { return big_endian(text_, 8); }
    std::size_t frame_bytes() const { return frame_header_bytes + page_bytes(); }
    std::string_view frame(std::size_t index) const {
        return std::string_view(text_).substr(header_bytes + index * frame_bytes(), frame_bytes());
    }
    WalChecksum checksum() const { return {(big_endian(text_, 0) & 1) != 0}; }

    std::string text_;
};

} // namespace

std::string check_wal(const std::filesystem::path& database) {
    std::ifstream in(database.string() + "-wal", std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(in), {});
    if (std::ranges::all_of(text, [](char c) { return c == 0; })) // none, or space that was got and never written
        return "";
    if (text.size() < header_bytes || !Wal(text).has_header())
        throw std::runtime_error(fmt::format("the heading of {}-wal is damaged", database.string()));
    Wal wal(std::move(text));
    std::size_t spoilt = 0, good = wal.good_frames();
    for (std::size_t i = good; i < wal.frames(); ++i)
        if (wal.is_of_this_log(i))
            spoilt += wal.ends_transaction(i);
    if (spoilt > 1)
        throw std::runtime_error(fmt::format("{}-wal is damaged in its frame {}, and {} transactions follow",
                                             database.string(), good + 1, spoilt));
    return spoilt == 0 ? ""
                       : fmt::format("the last transaction of {}-wal is not whole and left out: the power has failed, "
                                     "or the file is damaged",
                                     database.string());
}

} // namespace placedpar::monitor
