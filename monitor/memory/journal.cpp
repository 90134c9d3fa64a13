#include "monitor/memory/journal.hpp"

#include "text/user_error.hpp"

#include <boost/crc.hpp>
#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

namespace placedpar::monitor {

namespace {

constexpr std::string_view heading = "placedpar-monitor-journal 1 epoch ";
constexpr std::size_t checksum_digits = 8;

std::string checksum(std::string_view record) {
    boost::crc_32_type crc;
    crc.process_bytes(record.data(), record.size());
    return fmt::format("{:08x}", crc.checksum());
}

/// The record of a line without its newline; none when it is damaged.
std::optional<std::string_view> record_of(std::string_view line) {
    if (line.size() <= checksum_digits || line[checksum_digits] != ' ')
        return std::nullopt;
    std::string_view record = line.substr(checksum_digits + 1);
    if (line.substr(0, checksum_digits) != checksum(record))
        return std::nullopt;
    return record;
}

std::optional<std::uint64_t> epoch_of(std::string_view record) {
    std::uint64_t epoch = 0;
    if (!record.starts_with(heading))
        return std::nullopt;
    auto [end, error] = std::from_chars(record.data() + heading.size(), record.data() + record.size(), epoch);
    if (error != std::errc() || end != record.data() + record.size())
        return std::nullopt;
    return epoch;
}

JournalContent content_of(std::string_view text) {
    JournalContent content;
    while (content.good_bytes < text.size()) {
        std::size_t end = text.find('\n', content.good_bytes);
        auto record =
            end == text.npos ? std::nullopt : record_of(text.substr(content.good_bytes, end - content.good_bytes));
        if (!record)
            break;
        if (content.good_bytes > 0)
            content.records.emplace_back(*record);
        else if (auto epoch = epoch_of(*record))
            content.epoch = *epoch;
        else
            break;
        content.good_bytes = end + 1;
    }
    content.damaged_bytes = text.size() - content.good_bytes;
    return content;
}

} // namespace

Journal::Journal(std::filesystem::path path) : path_(std::move(path)) {
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
    if (file_ < 0)
        fail("cannot be opened");
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
        ::close(file_);
        throw UserError(fmt::format("{}: another placedpar monitor is using it", path_.string()));
    }
    off_t end = ::lseek(file_, 0, SEEK_END);
    bytes_ = end > 0 ? static_cast<std::size_t>(end) : 0;
}

Journal::~Journal() { ::close(file_); }

void Journal::fail(const char* what) const {
    throw UserError(fmt::format("{}: {}: {}", path_.string(), what, std::strerror(errno)));
}

JournalContent Journal::read() const {
    std::ifstream in(path_, std::ios::binary);
    if (!in)
        fail("cannot be read");
    return content_of(std::string(std::istreambuf_iterator<char>(in), {}));
}

void Journal::truncate(std::size_t good_bytes) {
    if (::ftruncate(file_, static_cast<off_t>(good_bytes)) != 0)
        fail("cannot be cut");
    bytes_ = good_bytes;
}

void Journal::begin(std::uint64_t epoch) {
    truncate(0);
    append(fmt::format("{}{}", heading, epoch));
}

void Journal::append(std::string_view record) {
    std::string line = fmt::format("{} {}\n", checksum(record), record);
    for (std::size_t done = 0; done < line.size();) {
        ssize_t written = ::write(file_, line.data() + done, line.size() - done);
        if (written < 0 && errno == EINTR)
            continue;
        if (written < 0) {
            int reason = errno;
            truncate(bytes_); // a torn record would hide those after it
            errno = reason;
            fail("cannot be appended to");
        }
        done += static_cast<std::size_t>(written);
    }
    bytes_ += line.size();
}

void Journal::sync() const {
    if (::fdatasync(file_) != 0)
        fail("cannot be brought to the disk");
}

} // namespace placedpar::monitor
