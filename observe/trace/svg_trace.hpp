#pragma once

#include "observe/trace/trace_writer.hpp"
#include "text/output_file.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace placedpar {

/// Draws a trace as a timeline in SVG, for pages and papers. Each node is a group of rows: its processor, its
/// processes, the directions of its links, its buses. A row without any activity is left out. A process and the
/// components of its PARs share a row. Such a row shows computing if one of these processes computes; otherwise waiting
/// for the processor if one of them waits for the processor; otherwise waiting for a partner. Bars with a gap too small
/// to see are joined. Arrows are the messages between rows.
class SvgTrace final : public TraceWriter {
public:
    /// Largest number of slices (bars) and messages of a drawing, because more could not be distinguished.
    static constexpr std::size_t most_entries = 20'000;

    /// REQUIRES: file and tracks outlive this object, and nothing has been written to the file.
    SvgTrace(OutputFile& file, const Tracks& tracks) : file_(file), tracks_(tracks) {}

    void write(const Slice& slice) override { slices_.push_back(slice); }
    void write(const MessageArrow&) override;
    void finish(Time begin, Time end, const std::string& why) override;

private:
    struct Message {
        std::size_t from, to; ///< tracks
        Time left, arrived;
    };

    OutputFile& file_;
    const Tracks& tracks_;
    std::vector<Slice> slices_;
    std::vector<Message> messages_;
};

} // namespace placedpar
