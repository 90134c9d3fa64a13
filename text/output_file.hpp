#pragma once

#include "text/temporary_file.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace placedpar {

/// A file that is written completely or not at all. The content goes to a temporary file, which replaces the file at
/// the end. A symbolic link stays, and its target is written; an existing file keeps its permissions. A device or a
/// pipe cannot be replaced, so it is written directly; so is standard output, which is the path "-"
/// (text/standard_streams.hpp).
class OutputFile {
public:
    /// Throws UserError, which names the file and the reason.
    explicit OutputFile(const std::filesystem::path&);
    /// Removes the temporary file unless finish() has replaced the destination with it.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Appends the text. An error is kept for finish() to report, so that write() can be called where nothing may
    /// throw.
    void write(std::string_view) noexcept;
    /// Throws UserError if the file could not be written completely. It is not an error if the reader of standard
    /// output stops reading.
    void finish();

private:
    void note_error() noexcept;
    void close() noexcept;

    std::filesystem::path name_;        ///< the path that the user gave
    std::filesystem::path destination_; ///< the file that gets the content at the end
    /// The file that gets the content first, unless the destination is a device or a pipe.
    std::optional<TemporaryFile> temporary_;
    std::FILE* file_ = nullptr;
    int error_ = 0;
};

/// Throws UserError, which names the file and the reason.
void write_whole(const std::filesystem::path&, std::string_view content);

/// Throws UserError if an OutputFile of this path would certainly fail: a folder is missing, the file must not be
/// written, or standard output goes to the same file. Call it before a long run, so that the run is not lost. If the
/// path is "-", reserves standard output for the file.
void require_writable(const std::filesystem::path&);

/// Throws UserError if one of the outputs is also the input or another output. An empty path stands for no file.
/// Standard input and standard output, both "-", are different.
void require_apart(std::span<const std::filesystem::path> outputs, const std::filesystem::path& input);

/// Writes to standard output immediately; if standard output receives a file, writes to standard error as print_error()
/// does. Throws UserError if the text could not be written completely. All output of commands uses this function, so
/// that a report lost to a full disk does not look like success. If the reader has gone, as with `head`, the command
/// continues and writes its files. Control characters in names and messages are made visible and cannot control the
/// terminal: escaped_but_paint(). REQUIRES: SIGPIPE is ignored.
void print_out(std::string_view text);

/// Writes the terminal control sequence `control` and then the text, escaped as in print_out(), to standard error. If
/// standard error cannot be written, the text is lost, and nothing else changes.
void print_error(std::string_view text, std::string_view control = "") noexcept;

} // namespace placedpar
