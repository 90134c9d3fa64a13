#pragma once

#include "text/temporary_file.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace placedpar {

/// A file that is written whole or not at all: to a temporary file, which takes its place at the end.
/// A symbolic link stays one, and what it leads to is written; a file that is there already keeps its permissions.
/// A device or a pipe has no name to take: it is written as it goes, and so is "-", standard output
/// (text/standard_streams.hpp).
class OutputFile {
public:
    /// Throws UserError, naming the file and the reason.
    explicit OutputFile(const std::filesystem::path&);
    /// Nothing has been written unless finish() was called.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// finish() reports what goes wrong here, so that this can be called where nothing may throw.
    void write(std::string_view) noexcept;
    /// Throws UserError when the file could not be written whole. Who reads standard output may stop reading.
    void finish();

private:
    void note_error() noexcept;
    void close() noexcept;

    std::filesystem::path name_;             ///< as the user gave it
    std::filesystem::path destination_;      ///< what takes the content in the end
    std::optional<TemporaryFile> temporary_; ///< what takes it before, where the destination is a file
    std::FILE* file_ = nullptr;
    int error_ = 0;
};

/// Throws UserError, naming the file and the reason.
void write_whole(const std::filesystem::path&, std::string_view content);

/// Throws UserError if an OutputFile of this path is sure to fail, so that a long run is not lost: in a folder that is
/// not there, a file without permission to write, the file that standard output goes to. Gives standard output to the
/// file if that is "-".
void require_writable(const std::filesystem::path&);

/// Throws UserError if one of the outputs is also the input or another output. An empty path is not a file, and
/// standard input and standard output, both "-", are two.
void require_apart(std::span<const std::filesystem::path> outputs, const std::filesystem::path& input);

/// Writes to standard output, at once; as print_error() does where a file takes standard output. Throws UserError when
/// it could not be written whole: everything that a command prints goes through here, so that a report that a full disk
/// has lost is not taken for a success. A reader that has gone, as `head` does, loses nothing that it wants, and the
/// command goes on to write its files. Control characters that came with names and messages are shown, and move no
/// terminal: escaped_but_paint(). REQUIRES: SIGPIPE is ignored.
void print_out(std::string_view text);

/// Writes to standard error, in the same way, behind what is to move the terminal. Where that cannot be written, the
/// text is lost, and everything else goes on as it would.
void print_error(std::string_view text, std::string_view control = "") noexcept;

} // namespace placedpar
