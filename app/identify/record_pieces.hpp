#pragma once

#include "explore/load.hpp"
#include "hydraulics/data/record_table.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// A record of any length, of a file, a pipe or standard input ("-"), read piece by piece: no more than two pieces of
/// the text are in memory. What is wrong is said as for load_record, the first 20 warnings of all pieces.
class RecordPieces {
public:
    static constexpr std::size_t piece_bytes = 1 << 20; ///< to the end of the line

    /// Throws RefusedInput where the file cannot be read. `stop` is asked before every reading and while a pipe gives
    /// nothing; after it the record is over.
    RecordPieces(const std::filesystem::path& path, hydraulics::RecordNeeds needs, WarningSink warn,
                 std::function<bool()> stop = {});
    ~RecordPieces();
    RecordPieces(const RecordPieces&) = delete;
    RecordPieces& operator=(const RecordPieces&) = delete;

    /// The next piece; none when the record is over. Throws RefusedInput.
    std::optional<hydraulics::Record> next();

    std::uint64_t bytes() const { return bytes_; } ///< read so far
    bool stopped() const { return stopped_; }
    /// Those that were shown.
    const std::vector<Diagnostic>& warnings() const { return warnings_; }

private:
    using File = std::shared_ptr<const SourceFile>;

    std::string next_lines();
    void fill();
    void report(std::vector<Diagnostic> faults, const File& file);
    void finish();

    std::string shown_;
    int descriptor_;
    hydraulics::RecordReader reader_;
    WarningSink warn_;
    std::function<bool()> stop_;
    std::string buffer_; ///< read, and not given yet
    bool over_ = false, stopped_ = false;
    std::uint64_t bytes_ = 0;
    std::size_t line_ = 1; ///< the next piece's first
    File first_;           ///< that has the header
    std::vector<Diagnostic> warnings_;
    std::size_t more_warnings_ = 0;
};

} // namespace placedpar
