#pragma once

#include "observe/trace/timeline.hpp"
#include "observe/trace/trace_writer.hpp"
#include "text/output_file.hpp"

#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace placedpar {

/// Throws UserError unless the name has the ending of a trace format.
void require_trace_format(const std::filesystem::path&);

/// A trace file, which shows for a part of a run what each processor, process and link did. The ending of its name
/// selects the format: .json (PerfettoTrace), .vcd (VcdTrace) or .svg (SvgTrace). A pipe or device without an ending,
/// and standard output ("-"), receive JSON.
class TraceFile {
public:
    /// Throws UserError as require_trace_format() does, and if the file cannot be written or the window is empty. The
    /// network may be destroyed afterwards.
    TraceFile(const std::filesystem::path&, const Network&, const TraceWindow&);

    TraceSink& sink() { return timeline_; }
    /// Completes the file, and returns lines of text that tell the user what is missing in the trace. Throws UserError
    /// if the file could not be written completely. If this function is not called, no file is left. `ended`: see
    /// Timeline::finish(). REQUIRES: the run is over.
    std::string finish(const RunResult&, std::span<const PathPart> critical_path = {}, const std::string& ended = "");

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
