#include "monitor/memory/mark.hpp"

#include "store/database.hpp"
#include "text/checksum.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace placedpar::monitor {

namespace {

namespace fs = std::filesystem;

fs::path mark_of(const fs::path& state_file) { return state_file.string() + "-mark"; }

/// Always as long: it is written over in place, within one sector.
std::string mark_text(std::uint64_t transactions) {
    std::string number = fmt::format("{:020}", transactions);
    return fmt::format("placedpar-monitor-mark {} {:016x}\n", number,
                       static_cast<std::uint64_t>(checksum_of("mark", number)));
}

} // namespace

std::optional<std::uint64_t> Mark::read(const fs::path& state_file) {
    std::ifstream in(mark_of(state_file), std::ios::binary);
    if (!in)
        return std::nullopt;
    std::string text(std::istreambuf_iterator<char>(in), {});
    std::uint64_t transactions = 0;
    constexpr std::size_t number_at = 23, digits = 20;
    if (text.size() > number_at + digits)
        std::from_chars(text.data() + number_at, text.data() + number_at + digits, transactions);
    if (text != mark_text(transactions))
        throw std::runtime_error(fmt::format("{} is damaged", mark_of(state_file).string()));
    return transactions;
}

Mark::Mark(const fs::path& state_file, std::uint64_t transactions)
    : path_(mark_of(state_file)), file_(::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0600)) {
    if (file_ < 0)
        fail();
    int folder = ::open(fs::absolute(path_).parent_path().c_str(), O_RDONLY | O_CLOEXEC);
    try {
        write(transactions);
        if (::fsync(file_) != 0 || folder < 0 || ::fsync(folder) != 0)
            fail();
    } catch (const store::DatabaseError&) {
        if (struct stat status{}; ::fstat(file_, &status) == 0 && status.st_size == 0)
            ::unlink(path_.c_str()); // on a full disk: an empty mark is a damaged one
        ::close(file_);
        ::close(folder);
        throw;
    }
    ::close(folder);
}

Mark::~Mark() { ::close(file_); }

void Mark::write(std::uint64_t transactions) {
    std::string text = mark_text(transactions);
    if (::pwrite(file_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
        fail();
}

void Mark::remove() {
    if (::unlink(path_.c_str()) != 0)
        fail();
}

void Mark::fail() const {
    throw store::DatabaseError(fmt::format("{}: {}", path_.string(), std::strerror(errno)), false);
}

} // namespace placedpar::monitor
