#include "iserver/streams.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <limits>
#include <utility>

namespace placedpar::iserver {

namespace {

/// A file. It has no buffer, so that it is complete even if PlacedPar is killed.
class FileStream : public Stream {
public:
    FileStream(OpenFile file, bool appends, WriteQuota& quota)
        : file_(std::move(file)), appends_(appends), quota_(quota) {}

    std::string read(std::size_t most) override;
    std::optional<std::string> line(std::size_t most) override;
    std::size_t write(std::string_view) override;
    bool seek(std::int32_t offset, std::int32_t origin) override;
    std::optional<std::int32_t> tell() override;

private:
    std::int64_t position() const { return ::lseek(file_.descriptor(), 0, SEEK_CUR); }

    OpenFile file_;
    bool appends_;
    WriteQuota& quota_;
};

std::string FileStream::read(std::size_t most) {
    std::string bytes(most, '\0');
    const ssize_t count = ::read(file_.descriptor(), bytes.data(), most);
    if (count < 0)
        error_ = errno;
    at_end_ = at_end_ || (count >= 0 && static_cast<std::size_t>(count) < most);
    bytes.resize(count < 0 ? 0 : static_cast<std::size_t>(count));
    return bytes;
}

/// Reads a line. Reads beyond the newline, and then sets the position back to the byte after the newline.
std::optional<std::string> FileStream::line(std::size_t most) {
    const bool was_at_end = at_end_;
    std::string bytes = read(most);
    if (bytes.empty())
        return most > 0 ? std::nullopt : std::optional(bytes);
    const std::size_t newline = bytes.find('\n');
    if (newline == bytes.npos)
        return bytes;
    at_end_ = was_at_end;
    const auto unused = static_cast<std::int64_t>(bytes.size() - newline - 1);
    ::lseek(file_.descriptor(), -unused, SEEK_CUR);
    return bytes.substr(0, newline);
}

/// Writes as many bytes as the quota allows. The quota also counts the bytes between the file's end and the position,
/// which a write fills with zeros.
std::size_t FileStream::write(std::string_view bytes) {
    struct stat status;
    if (bytes.empty() || ::fstat(file_.descriptor(), &status) != 0)
        return 0;
    const auto gap = static_cast<std::uint64_t>(appends_ ? 0 : std::max<std::int64_t>(position() - status.st_size, 0));
    const auto allowed = static_cast<std::size_t>(quota_.take(bytes.size(), gap));
    const ssize_t count = allowed > 0 ? ::write(file_.descriptor(), bytes.data(), allowed) : 0;
    if (count < 0)
        error_ = errno;
    else if (static_cast<std::size_t>(count) < bytes.size())
        error_ = ENOSPC;
    return count < 0 ? 0 : static_cast<std::size_t>(count);
}

bool FileStream::seek(std::int32_t offset, std::int32_t origin) {
    if (origin < 1 || origin > 3)
        return false;
    const std::int64_t before = position();
    const std::int64_t after = ::lseek(file_.descriptor(), offset,
                                       origin == 1   ? SEEK_SET
                                       : origin == 2 ? SEEK_CUR
                                                     : SEEK_END);
    if (after < 0)
        return false;
    if (after > std::numeric_limits<std::int32_t>::max()) {
        ::lseek(file_.descriptor(), before, SEEK_SET);
        return false;
    }
    at_end_ = false;
    return true;
}

std::optional<std::int32_t> FileStream::tell() {
    const std::int64_t here = position();
    if (here < 0 || here > std::numeric_limits<std::int32_t>::max())
        return std::nullopt;
    return static_cast<std::int32_t>(here);
}

/// Stream 0: the lines that the user types on the terminal.
class TerminalInput : public Stream {
public:
    explicit TerminalInput(Terminal& terminal) : terminal_(terminal) {}

    std::string read(std::size_t most) override;
    std::optional<std::string> line(std::size_t most) override;
    std::size_t write(std::string_view) override {
        error_ = EBADF;
        return 0;
    }
    bool is_terminal() const override { return terminal_.is_interactive(); }

private:
    std::string front(std::size_t most);

    Terminal& terminal_;
    std::string rest_; ///< the rest of a line
};

/// Returns the first bytes of the current line, at most `most`; "" at the end of the input.
std::string TerminalInput::front(std::size_t most) {
    if (rest_.empty() && most > 0)
        rest_ = terminal_.line();
    std::string front = rest_.substr(0, most);
    rest_.erase(0, front.size());
    at_end_ = at_end_ || (front.size() < most && !front.ends_with('\n'));
    return front;
}

/// Returns up to `most` bytes. If a person types them, returns after each line, because the person may expect an answer
/// before typing the next one.
std::string TerminalInput::read(std::size_t most) {
    std::string bytes = front(most);
    while (!terminal_.is_interactive() && !at_end_ && bytes.size() < most)
        bytes += front(most - bytes.size());
    return bytes;
}

std::optional<std::string> TerminalInput::line(std::size_t most) {
    std::string line = front(most);
    if (line.empty() && most > 0)
        return std::nullopt;
    if (line.ends_with('\n'))
        line.pop_back();
    return line;
}

class TerminalOutput : public Stream {
public:
    TerminalOutput(Terminal& terminal, VisibleText& visible, WriteQuota& quota)
        : terminal_(terminal), visible_(visible), quota_(quota) {}

    std::string read(std::size_t) override {
        error_ = EBADF;
        return "";
    }
    std::optional<std::string> line(std::size_t) override {
        error_ = EBADF;
        return std::nullopt;
    }
    std::size_t write(std::string_view bytes) override {
        const auto count = static_cast<std::size_t>(quota_.take(bytes.size()));
        if (count < bytes.size())
            error_ = ENOSPC;
        if (count > 0)
            terminal_.write(visible_.next(bytes.substr(0, count)));
        return count;
    }
    bool is_terminal() const override { return terminal_.is_interactive(); }

private:
    Terminal& terminal_;
    VisibleText& visible_;
    WriteQuota& quota_;
};

} // namespace

std::uint64_t WriteQuota::take(std::uint64_t bytes, std::uint64_t gap) {
    const std::uint64_t taken = gap < left_ ? std::min(bytes, left_ - gap) : 0;
    exceeded_ = exceeded_ || taken < bytes;
    left_ -= taken > 0 ? gap + taken : 0;
    return taken;
}

Streams::Streams(const HostFolder& folder, Terminal& terminal, VisibleText& visible, WriteQuota& quota)
    : folder_(folder), quota_(quota) {
    streams_[0] = std::make_unique<TerminalInput>(terminal);
    streams_[1] = std::make_unique<TerminalOutput>(terminal, visible, quota);
    streams_[2] = std::make_unique<TerminalOutput>(terminal, visible, quota);
}

std::optional<std::int32_t> Streams::open(std::string_view name, OpenMode mode) {
    const auto free = std::ranges::find_if(streams_, [](const auto& stream) { return !stream; });
    if (free == streams_.end())
        return std::nullopt;
    bool created = false;
    OpenFile file = folder_.open(name, mode, created);
    if (!file)
        return std::nullopt;
    if (created && quota_.take(1, WriteQuota::new_file - 1) == 0) {
        folder_.remove(name);
        return std::nullopt;
    }
    const bool appends = mode == OpenMode::append || mode == OpenMode::append_and_read;
    *free = std::make_unique<FileStream>(std::move(file), appends, quota_);
    return static_cast<std::int32_t>(free - streams_.begin());
}

bool Streams::close(std::int32_t number) {
    if (!find(number))
        return false;
    if (number > 2)
        streams_[static_cast<std::size_t>(number)].reset();
    return true;
}

Stream* Streams::find(std::int32_t number) {
    const auto index = static_cast<std::uint32_t>(number);
    return index < most ? streams_[index].get() : nullptr;
}

} // namespace placedpar::iserver
