#pragma once

#include "observe/trace/timeline.hpp"
#include "observe/trace/trace_writer.hpp"
#include "text/output_file.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace placedpar {

/// Throws UserError when the name's ending says no format that a trace can be written in.
void require_trace_format(const std::filesystem::path&);

/// A file that a run is traced to, in the format that its name's ending says: .json (PerfettoTrace) or .vcd (VcdTrace).
/// A pipe or a device whose name has no ending takes JSON, and so does "-", standard output.
class TraceFile {
public:
    /// Throws UserError as require_trace_format(), when the file cannot be written, and when the window is empty. The
    /// network is looked at only here.
    TraceFile(const std::filesystem::path&, const Network&, const TraceWindow&);

    TraceSink& sink() { return timeline_; }
    /// REQUIRES: the run is over. Returns what the user should know about what is not in the trace, in lines of text.
    /// Throws UserError when the file could not be written whole. Without this call nothing is written.
    std::string finish(const RunResult&, std::span<const PathPart> critical_path = {});

private:
    std::string warnings() const;

    std::filesystem::path path_;
    TraceWindow window_;
    OutputFile file_;
    Tracks tracks_;
    std::unique_ptr<TraceWriter> writer_;
    Timeline timeline_;
};

} // namespace placedpar
