#pragma once

#include "observe/trace/trace_writer.hpp"
#include "text/output_file.hpp"

#include <cstdint>
#include <string>

namespace placedpar {

/// Writes a trace in the Trace Event Format (JSON) during the run; ui.perfetto.dev and chrome://tracing show it as a
/// timeline. In this format a node of the network is a "process", and each of its tracks (the timeline of a processor,
/// process or link) a "thread".
///
/// A slice (a bar of a timeline) is a complete event (X). A slice without an end is an event that only begins (B). A
/// message is a flow (s, f) between slices. The end of the trace is an instant (i) that states the reason. Names and
/// order are metadata (M).
///
/// The critical path is a separate "process" above all other processes. One thread has the whole path; each processor
/// and link on the path has a thread with the parts that use it. The parts are red in viewers that accept colours
/// (cname). A flow leads from each part to the next, so that one line leads from the beginning of the run to its end.
class PerfettoTrace final : public TraceWriter {
public:
    /// REQUIRES: file and tracks outlive this object, and nothing has been written to the file.
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
