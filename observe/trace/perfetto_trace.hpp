#pragma once

#include "observe/trace/trace_writer.hpp"
#include "text/output_file.hpp"

#include <cstdint>
#include <string>

namespace placedpar {

/// A trace in the Trace Event Format (JSON), which ui.perfetto.dev and chrome://tracing show as a timeline. A node is a
/// process of that format, a track one of its threads. It is written as the run goes.
///
/// A slice is a complete event (X), or one that begins and does not end (B) if it is open. A message is a flow (s, f)
/// from slice to slice. The end of the trace is an instant (i) that says why. Names and order are metadata (M).
///
/// A critical path is a process of its own above all others: a thread has the whole path, and each processor and link
/// that it leads over one with its parts there, all of them red where a viewer lets a trace choose (cname). A flow
/// leads from each part to the next: one line from the beginning of the run to its end.
class PerfettoTrace final : public TraceWriter {
public:
    /// REQUIRES: file and tracks outlive it, and nothing has been written to the file.
    PerfettoTrace(OutputFile&, const Tracks&);

    void write(const Slice&) override;
    void write(const MessageArrow&) override;
    void draw_path(std::span<const PathPart>) override;
    void finish(Time begin, Time end, const std::string& why) override;

private:
    void add(const std::string& event);
    void add_name(const char* what, const std::string& where, const std::string& value);
    void write_names();
    void write_part(const PathPart&, std::size_t thread);
    void write_step(const PathPart& from, std::size_t from_thread, const PathPart& to, std::size_t to_thread);
    void write_path_names(std::span<const PathPart>);
    std::string place_on_path(std::size_t thread) const;
    std::string place(std::size_t track) const;

    OutputFile& file_;
    const Tracks& tracks_;
    std::uint64_t arrows_ = 0;
    bool is_first_ = true;
};

} // namespace placedpar
