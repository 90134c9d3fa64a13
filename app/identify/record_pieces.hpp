#pragma once

#include "explore/identify/ways.hpp"
#include "hydraulics/data/record_table.hpp"
#include "text/repeated_faults.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Reads an excavator's record piece by piece from a file, a pipe or standard input ("-"), so that it may be longer
/// than the memory. At most two pieces of the text are in memory. Errors are reported as load_record() reports them.
/// Only the first 20 warnings are shown. A warning that occurs again in a later piece is only counted; the counts are
/// shown at the end.
class RecordPieces final : public RecordStream {
public:
    /// Throws RefusedInput if the file cannot be read. `stop` is called before every read and while a pipe is empty.
    /// The record ends when `stop` returns true.
    RecordPieces(const std::filesystem::path& path, hydraulics::RecordNeeds needs, WarningSink warn,
                 std::function<bool()> stop = {});
    ~RecordPieces() override;
    RecordPieces(const RecordPieces&) = delete;
    RecordPieces& operator=(const RecordPieces&) = delete;

    /// Throws RefusedInput.
    std::optional<hydraulics::Record> next() override;

    std::uint64_t bytes() const override { return bytes_; }
    /// Returns the date of the record's time 0, in s since 1970. Returns nullopt if the file has no dates or no piece
    /// has been read.
    std::optional<double> begun_s() const { return reader_.begun_s(); }
    bool stopped() const override { return stopped_; }
    /// Returns the warnings that were shown.
    const std::vector<Diagnostic>& warnings() const override { return warnings_; }

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
    std::string buffer_; ///< text that was read but not yet returned
    bool over_ = false, stopped_ = false;
    std::uint64_t bytes_ = 0;
    std::size_t line_ = 1; ///< number of the next piece's first line
    File first_;           ///< the first piece, which has the header
    std::vector<Diagnostic> warnings_;
    std::size_t more_warnings_ = 0;
    RepeatedFaults repeated_;
};

} // namespace placedpar
