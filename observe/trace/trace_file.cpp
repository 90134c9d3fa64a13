#include "observe/trace/trace_file.hpp"

#include "observe/trace/perfetto_trace.hpp"
#include "observe/trace/svg_trace.hpp"
#include "observe/trace/vcd_trace.hpp"
#include "text/standard_streams.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace placedpar {

namespace {

enum class TraceFormat { json, vcd, svg };

TraceFormat trace_format(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    std::error_code error;
    if (ending == ".json" || is_standard_stream(path) || (ending.empty() && std::filesystem::is_other(path, error)))
        return TraceFormat::json;
    if (ending == ".vcd")
        return TraceFormat::vcd;
    if (ending == ".svg")
        return TraceFormat::svg;
    throw UserError(fmt::format("{}: unknown kind of trace: the name must end in .json for ui.perfetto.dev, .vcd for "
                                "GTKWave, or .svg for a drawing",
                                path.string()));
}

std::unique_ptr<TraceWriter> make_writer(TraceFormat format, OutputFile& file, const Tracks& tracks) {
    switch (format) {
    case TraceFormat::vcd: return std::make_unique<VcdTrace>(file, tracks);
    case TraceFormat::svg: return std::make_unique<SvgTrace>(file, tracks);
    case TraceFormat::json: break;
    }
    return std::make_unique<PerfettoTrace>(file, tracks);
}

/// Returns the window with `most_entries` limited to what a file of this format can show.
TraceWindow window_for(const std::filesystem::path& path, TraceWindow window) {
    if (trace_format(path) == TraceFormat::svg)
        window.most_entries = std::min(window.most_entries, SvgTrace::most_entries);
    return window;
}

} // namespace

void require_trace_format(const std::filesystem::path& path) { trace_format(path); }

TraceFile::TraceFile(const std::filesystem::path& path, const Network& network, const TraceWindow& window)
    : path_(path), window_(window_for(path, require_time_in(window))), file_(path), tracks_(network),
      writer_(make_writer(trace_format(path), file_, tracks_)), timeline_(tracks_, window_, *writer_) {}

std::string TraceFile::finish(const RunResult& result, std::span<const PathPart> critical_path,
                              const std::string& ended) {
    writer_->draw_path(critical_path);
    timeline_.finish(result, ended);
    file_.finish();
    return warnings();
}

std::string TraceFile::warnings() const {
    if (std::optional<Time> full = timeline_.full_at())
        return fmt::format("{}: the trace is full and ends at {}, after {} entries; choose a part of the run "
                           "with --trace-from and --trace-until, or raise --trace-limit\n",
                           shown_output(path_), to_string(*full), window_.most_entries);
    if (std::string why = timeline_.why_empty(); !why.empty())
        return fmt::format("{}: the trace is empty: {}\n", shown_output(path_), why);
    return "";
}

} // namespace placedpar
