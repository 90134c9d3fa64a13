#pragma once

#include "netlist/run_report.hpp"
#include "observe/page/page_recorder.hpp"
#include "observe/trace/timeline.hpp"
#include "report/run_report.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace placedpar {

/// Holds what a page shows of a run besides the timelines.
struct PageContent {
    const Network& network;
    const RunReport& report;
    const Manifest& manifest;
    const GenerationLog& searches;
};

/// Shows a run as one HTML file, which a browser displays without internet. The page shows timelines, measurements, the
/// cycle of a deadlock, convergence, and the network. A slider selects a time; the colours of the network show the load
/// at this time. The file stays below 64 megabytes. For a very long run, it has the single activities and messages only
/// at the beginning and the end, and in between only the load.
class RunPage {
public:
    /// Records the part of the run in the window. Throws UserError if the window is empty. The network may be destroyed
    /// afterwards.
    RunPage(const Network&, const TraceWindow&);

    TraceSink& sink() { return timeline_; }
    /// Returns the page. The critical path, if given, is a line through the timelines. REQUIRES: the run is over;
    /// called once.
    std::string html(const PageContent&, std::span<const PathPart> critical_path = {});
    /// Returns lines of text that tell the user what is missing on the page in this file. REQUIRES: the run is over.
    std::string warnings(const std::filesystem::path&) const;

private:
    Tracks tracks_;
    page::PageRecorder recorder_;
    Timeline timeline_;
};

} // namespace placedpar
