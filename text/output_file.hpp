#pragma once

#include "text/temporary_file.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace placedpar {

/// A file that is written completely or not at all. The content goes to a temporary file, which replaces the
/// destination at the end. If the path is a symbolic link, the target of the link is replaced. A replaced file passes
/// on its permissions. A device, a pipe and standard output (the path "-", text/standard_streams.hpp) cannot be
/// replaced: they are written directly.
class OutputFile {
public:
    /// Throws UserError if the file cannot be written; the error names the file and the reason.
    explicit OutputFile(const std::filesystem::path&);
    /// Removes the temporary file, if it has not replaced the destination.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Appends the text. After an error, finish() throws; write() itself never throws, so that destructors can call it.
    void write(std::string_view) noexcept;
    /// Completes the file, and replaces the destination with it. Throws UserError if the file could not be written
    /// completely. If the reader of standard output stops reading, this counts as success.
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

/// Throws UserError if the file cannot be written; the error names the file and the reason.
void write_whole(const std::filesystem::path&, std::string_view content);

/// Checks a path before a long run, so that the results are not lost. Throws UserError if an OutputFile of this path
/// would certainly fail: a folder is missing, the file is protected, or standard output is redirected to this file. If
/// the path is "-", calls give_standard_output_to_a_file().
void require_writable(const std::filesystem::path&);

/// Throws UserError if one of the outputs is also the input or another output. An empty path means that there is no
/// such file. The input "-" is standard input, the output "-" is standard output; these are different.
void require_apart(std::span<const std::filesystem::path> outputs, const std::filesystem::path& input);

/// Writes to standard output immediately. If the user has directed an output file to standard output ("-"), writes to
/// standard error, as print_error() does. Throws UserError if the text could not be written completely: all output of
/// commands uses this function, so that a full disk is noticed. If the reader of standard output has gone, as after `|
/// head`, nothing is thrown, and the command can still write its files. Control characters are shown as escapes, so
/// that no text can control the terminal (escaped_but_paint()). REQUIRES: SIGPIPE is ignored.
void print_out(std::string_view text);

/// Writes the terminal control sequence `control`, then the text with control characters as escapes, to standard error.
/// If this fails, the text is lost, and the program continues.
void print_error(std::string_view text, std::string_view control = "") noexcept;

} // namespace placedpar
