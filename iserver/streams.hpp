#pragma once

#include "iserver/host_folder.hpp"
#include "iserver/terminal.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace placedpar::iserver {

/// The number of bytes that a transputer program may still write, to all files and the terminal together. This limits
/// the damage that a faulty program can do.
class WriteQuota {
public:
    /// A new file counts as this number of bytes, so that a program cannot make millions of empty files.
    static constexpr std::uint64_t new_file = 4096;

    explicit WriteQuota(std::uint64_t bytes) : left_(bytes) {}
    /// Takes bytes from the quota for a write of `bytes` bytes. If the write begins beyond the end of a file, the `gap`
    /// before it is filled with zeros and also counts. Returns how many of `bytes` may be written: as many as are left
    /// after the whole gap. If this number is 0, takes nothing.
    std::uint64_t take(std::uint64_t bytes, std::uint64_t gap = 0);
    /// Returns whether a program asked for more than was left.
    bool exceeded() const { return exceeded_; }

private:
    std::uint64_t left_;
    bool exceeded_ = false;
};

/// A stream in the sense of C: bytes, a flag for the end, and an error number.
class Stream {
public:
    virtual ~Stream() = default;

    /// Returns up to `most` bytes; fewer at the end of the stream, and after a line that a person typed.
    virtual std::string read(std::size_t most) = 0;
    /// Returns up to `most` bytes of the next line, without its newline. Returns nullopt at the end.
    virtual std::optional<std::string> line(std::size_t most) = 0;
    /// Writes the bytes. Returns how many of them were written.
    virtual std::size_t write(std::string_view) = 0;
    /// Seeks from the start (1), the current position (2) or the end (3). Returns whether this succeeded.
    virtual bool seek(std::int32_t, std::int32_t) { return false; }
    /// Returns the position; nullopt if the stream has no position, or if it does not fit into 32 bits.
    virtual std::optional<std::int32_t> tell() { return std::nullopt; }
    virtual bool is_terminal() const { return false; }

    /// Returns whether a read has met the end of the stream. As with feof(), reading the last byte is not enough.
    bool at_end() const { return at_end_; }
    /// Returns the number of the last error, as in errno; 0 if there was none.
    int error() const { return error_; }

protected:
    bool at_end_ = false;
    int error_ = 0;
};

/// The streams of a transputer program. Streams 0, 1 and 2 are the input, output and error output on the terminal; the
/// others are files.
class Streams {
public:
    static constexpr std::size_t most = 256; ///< number of streams, including the terminal's streams

    /// REQUIRES: the arguments outlive this object.
    Streams(const HostFolder&, Terminal&, VisibleText&, WriteQuota&);

    /// Opens a file under the lowest free number. Returns nullopt if this fails.
    std::optional<std::int32_t> open(std::string_view name, OpenMode);
    /// Closes a file. Returns false if there is no such file. The streams of the terminal stay open.
    bool close(std::int32_t number);
    /// Returns the stream of this number; null if there is none.
    Stream* find(std::int32_t number);

private:
    const HostFolder& folder_;
    WriteQuota& quota_;
    std::array<std::unique_ptr<Stream>, most> streams_;
};

} // namespace placedpar::iserver
