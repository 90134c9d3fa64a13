#include "text/output_file.hpp"

#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace placedpar {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const char* reason) {
    throw UserError(fmt::format("{}: cannot be written: {}", shown_output(path), reason));
}

[[noreturn]] void refuse(const fs::path& path, int error) { refuse(path, std::strerror(error)); }

/// Returns the path to which a chain of symbolic links leads. A file need not exist there.
fs::path follow_links(const fs::path& path) {
    constexpr int most_links = 40; // the same limit as in Linux
    fs::path end = path;
    std::error_code error;
    for (int links = 0; fs::is_symlink(end, error); ++links) {
        if (links == most_links)
            refuse(path, ELOOP);
        end = end.parent_path() / fs::read_symlink(end, error);
    }
    return end;
}

/// Returns whether the file's permissions allow someone to write. Root could write every file, but a file without write
/// permission is refused for root, too.
bool may_write(const fs::path& path, const struct stat& file) {
    constexpr mode_t by_anybody = S_IWUSR | S_IWGRP | S_IWOTH;
    return (file.st_mode & by_anybody) != 0 && ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

/// Returns the path of the file that gets the content at the end. Throws UserError if this is a folder, or must not be
/// written.
fs::path destination_of(const fs::path& path) {
    if (is_standard_stream(path))
        return path;
    struct stat file = {};
    bool there = ::stat(path.c_str(), &file) == 0;
    if (there && S_ISDIR(file.st_mode))
        refuse(path, EISDIR);
    if (there && !may_write(path, file))
        refuse(path, EACCES);
    return there && !S_ISREG(file.st_mode) ? path : follow_links(path);
}

/// Returns whether the destination is standard output, a device or a pipe, which must not be replaced by a file.
bool is_written_as_it_goes(const fs::path& destination) {
    std::error_code error;
    return is_standard_stream(destination) || fs::is_other(destination, error);
}

/// Returns a stream to the descriptor. Closing the stream leaves the descriptor open.
std::FILE* stream_to(int descriptor) {
    int copy = ::dup(descriptor);
    return copy < 0 ? nullptr : ::fdopen(copy, "wb");
}

std::FILE* open_for_writing(const fs::path& path) {
    if (!is_standard_stream(path))
        return std::fopen(path.c_str(), "wb");
    std::fflush(stdout);
    give_standard_output_to_a_file();
    return stream_to(STDOUT_FILENO);
}

bool are_one_file(const fs::path& a, const fs::path& b) {
    if (is_standard_stream(a) || is_standard_stream(b))
        return a == b;
    std::error_code error;
    if (fs::equivalent(a, b, error))
        return true;
    auto full = [&](const fs::path& path) { return fs::weakly_canonical(fs::absolute(follow_links(path)), error); };
    return full(a) == full(b);
}

bool takes_standard_output(const fs::path& path) {
    struct stat file = {}, standard_output = {};
    return ::stat(path.c_str(), &file) == 0 && S_ISREG(file.st_mode) && ::fstat(STDOUT_FILENO, &standard_output) == 0 &&
           file.st_dev == standard_output.st_dev && file.st_ino == standard_output.st_ino;
}

} // namespace

OutputFile::OutputFile(const fs::path& path) : name_(path), destination_(destination_of(path)) {
    if (is_written_as_it_goes(destination_))
        file_ = open_for_writing(destination_);
    else if (temporary_.emplace(destination_).descriptor() >= 0)
        file_ = stream_to(temporary_->descriptor());
    if (!file_)
        refuse(name_, errno);
    struct stat before = {};
    if (temporary_ && ::stat(destination_.c_str(), &before) == 0 &&
        ::fchmod(::fileno(file_), before.st_mode & 07777) != 0)
        note_error();
}

OutputFile::~OutputFile() {
    if (file_)
        close();
}

void OutputFile::note_error() noexcept {
    if (error_ == 0)
        error_ = errno;
}

void OutputFile::close() noexcept {
    if (std::fclose(file_) != 0)
        note_error();
    file_ = nullptr;
}

void OutputFile::write(std::string_view text) noexcept {
    if (error_ == 0 && std::fwrite(text.data(), 1, text.size(), file_) != text.size())
        note_error();
}

void OutputFile::finish() {
    close();
    if (error_ == 0 && temporary_ && !temporary_->take_place())
        note_error();
    temporary_.reset();
    if (error_ != 0 && !(is_standard_stream(name_) && error_ == EPIPE))
        refuse(name_, error_);
}

void write_whole(const fs::path& path, std::string_view content) {
    OutputFile file(path);
    file.write(content);
    file.finish();
}

void require_writable(const fs::path& path) {
    if (is_standard_stream(path))
        return give_standard_output_to_a_file();
    if (takes_standard_output(path))
        refuse(path, "standard output is written to the same file; choose another name");
    if (!is_written_as_it_goes(destination_of(path)))
        OutputFile file(path); // its destructor removes the temporary file
}

void require_apart(std::span<const fs::path> outputs, const fs::path& input) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        if (outputs[i].empty())
            continue;
        if (!input.empty() && !is_standard_stream(input) && are_one_file(outputs[i], input))
            refuse(outputs[i], "the output file is also the input; choose another name");
        for (std::size_t j = 0; j < i; ++j)
            if (!outputs[j].empty() && are_one_file(outputs[i], outputs[j]))
                refuse(outputs[i], "two outputs have the same file name; choose two names");
    }
}

} // namespace placedpar
