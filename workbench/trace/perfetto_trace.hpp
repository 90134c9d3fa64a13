#pragma once

#include "text/output_file.hpp"
#include "workbench/trace/trace_writer.hpp"

#include <cstdint>
#include <string>

namespace placedpar {

/// A trace in the Trace Event Format (JSON), which ui.perfetto.dev and chrome://tracing show as a timeline. A node is a
/// process of that format, a track one of its threads. It is written as the run goes.
///
/// A slice is a complete event (X), or one that begins and does not end (B) if it is open. A message is a flow (s, f)
/// from slice to slice. The end of the trace is an instant (i) that says why. Names and order are metadata (M).
class PerfettoTrace final : public TraceWriter {
public:
    /// REQUIRES: file and tracks outlive it, and nothing has been written to the file.
    PerfettoTrace(OutputFile&, const Tracks&);

    void write(const Slice&) override;
    void write(const Passage&) override;
    void finish(Time begin, Time end, const std::string& why) override;

private:
    void add(const std::string& event);
    void write_names();
    std::string place(std::size_t track) const;

    OutputFile& file_;
    const Tracks& tracks_;
    std::uint64_t passages_ = 0;
    bool is_first_ = true;
};

} // namespace placedpar
