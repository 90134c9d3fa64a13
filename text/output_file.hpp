#pragma once

#include "text/temporary_file.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace placedpar {

/// A file that is written completely or not at all: the content goes to a temporary file, which takes the file's place
/// at the end. A symbolic link stays, and its target is written; an existing file keeps its permissions. A device or a
/// pipe cannot be replaced, so it is written directly, as is "-", standard output (text/standard_streams.hpp).
class OutputFile {
public:
    /// Throws UserError that names the file and the reason.
    explicit OutputFile(const std::filesystem::path&);
    /// Removes the temporary file unless finish() has replaced the destination with it.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Errors are reported by finish(), so that this can be called where nothing may throw.
    void write(std::string_view) noexcept;
    /// Throws UserError if the file could not be written completely. A reader of standard output may stop reading.
    void finish();

private:
    void note_error() noexcept;
    void close() noexcept;

    std::filesystem::path name_;             ///< as the user gave it
    std::filesystem::path destination_;      ///< the file that gets the content in the end
    std::optional<TemporaryFile> temporary_; ///< the file that gets the content first, if the destination is a file
    std::FILE* file_ = nullptr;
    int error_ = 0;
};

/// Writes a whole file. Throws UserError that names the file and the reason.
void write_whole(const std::filesystem::path&, std::string_view content);

/// Throws UserError if an OutputFile of this path would certainly fail, so that a long run is not lost: a missing
/// folder, a file without write permission, or the file to which standard output goes. If the path is "-", reserves
/// standard output for the file.
void require_writable(const std::filesystem::path&);

/// Throws UserError if one of the outputs is also the input or another output. An empty path stands for no file.
/// Standard input and standard output, both "-", are different.
void require_apart(std::span<const std::filesystem::path> outputs, const std::filesystem::path& input);

/// Writes to standard output at once, or as print_error() does if a file takes standard output. Throws UserError if the
/// text could not be written completely. All output of commands goes through here, so that a report lost to a full disk
/// does not look like success. If the reader has gone, as with `head`, the command continues and writes its files.
/// Control characters from names and messages are made visible and cannot control the terminal: escaped_but_paint().
/// REQUIRES: SIGPIPE is ignored.
void print_out(std::string_view text);

/// Writes to standard error in the same way, after the terminal control sequence `control`. If standard error cannot be
/// written, the text is lost, and nothing else changes.
void print_error(std::string_view text, std::string_view control = "") noexcept;

} // namespace placedpar
