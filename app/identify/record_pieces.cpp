#include "app/identify/record_pieces.hpp"

#include "text/load_source.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

namespace placedpar {

namespace {

[[noreturn]] void refuse(const std::string& shown, const std::string& why) {
    throw RefusedInput(fmt::format("{}: error: {}\n", shown, why));
}

int opened(const std::filesystem::path& path) {
    if (is_standard_stream(path))
        return STDIN_FILENO;
    if (auto why = why_not_a_file(path); !why.empty())
        refuse(shown_input(path), why);
    int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        refuse(shown_input(path), "the file cannot be opened for reading");
    return descriptor;
}

/// Waits briefly for input or the end of the input, because a read from a pipe could block. Returns whether a read
/// would not block.
bool readable(int descriptor) {
    constexpr int patience_ms = 200;
    pollfd asked{descriptor, POLLIN, 0};
    return ::poll(&asked, 1, patience_ms) > 0; // false if a signal interrupts the wait
}

} // namespace

RecordPieces::RecordPieces(const std::filesystem::path& path, hydraulics::RecordNeeds needs, WarningSink warn,
                           std::function<bool()> stop)
    : shown_(shown_input(path)), descriptor_(opened(path)), reader_(std::move(needs)), warn_(std::move(warn)),
      stop_(std::move(stop)) {}

RecordPieces::~RecordPieces() {
    if (descriptor_ != STDIN_FILENO)
        ::close(descriptor_);
}

void RecordPieces::fill() {
    std::array<char, 1 << 16> piece;
    while (!over_ && buffer_.size() < piece_bytes) {
        if (stop_ && stop_()) {
            over_ = stopped_ = true;
            return;
        }
        if (!readable(descriptor_))
            continue;
        const ssize_t size = ::read(descriptor_, piece.data(), piece.size());
        if (size < 0 && errno != EINTR)
            refuse(shown_, "the file cannot be read to its end: " + std::generic_category().message(errno));
        over_ = size == 0;
        if (size > 0) {
            buffer_.append(piece.data(), static_cast<std::size_t>(size));
            bytes_ += static_cast<std::uint64_t>(size);
        }
    }
}

std::string RecordPieces::next_lines() {
    fill();
    const std::size_t end = buffer_.rfind('\n');
    // A line that is too long is refused even if it is incomplete. After a stop, an incomplete line is dropped.
    const bool whole = over_ && !stopped_;
    const std::size_t size = whole || end == std::string::npos ? buffer_.size() : end + 1;
    std::string lines = buffer_.substr(0, stopped_ && end == std::string::npos ? 0 : size);
    buffer_.erase(0, size);
    return lines;
}

std::optional<hydraulics::Record> RecordPieces::next() {
    const std::string lines = next_lines();
    if (bytes_ == 0 && !stopped_ && shown_ == shown_input("-"))
        refuse(shown_, "standard input is empty or closed");
    if (lines.empty() && first_) {
        finish();
        return std::nullopt;
    }
    if (lines.empty() && stopped_)
        return std::nullopt;
    LoadedSource source = check_source(shown_, lines, line_);
    if (!first_)
        first_ = source.file;
    report(std::move(source.problems), source.file);
    hydraulics::ReadRecord read = reader_.read(source.file->text());
    line_ += static_cast<std::size_t>(std::ranges::count(lines, '\n'));
    report(std::move(read.faults), source.file);
    return std::move(*read.record);
}

void RecordPieces::finish() {
    report(reader_.finish(), first_);
    if (const std::string later = repeated_.later(); !later.empty())
        warn_(later);
    if (more_warnings_ > 0)
        warn_(not_shown(std::exchange(more_warnings_, 0), Severity::warning));
}

void RecordPieces::report(std::vector<Diagnostic> faults, const File& file) {
    std::string warnings;
    std::vector<Diagnostic> errors;
    for (Diagnostic& fault : repeated_.take(std::move(faults))) {
        fault.location.file = fault.location.line != 0 && fault.location.line < file->first_line() ? first_ : file;
        if (fault.severity == Severity::error)
            errors.push_back(std::move(fault));
        else if (warnings_.size() == most_faults_shown)
            ++more_warnings_;
        else
            warnings += render(warnings_.emplace_back(std::move(fault)));
    }
    if (!warnings.empty())
        warn_(warnings);
    if (errors.empty())
        return;
    const std::size_t shown = std::min(errors.size(), most_faults_shown), more = errors.size() - shown;
    errors.resize(shown);
    throw RefusedInput(render(errors) + not_shown(more, Severity::error));
}

} // namespace placedpar
