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
/// cycle of a deadlock, convergence, and the network. A slider selects the time whose load colours the network. The
/// file stays below 64 megabytes: of a very long run it has the slices and messages at the beginning and the end, and
/// only the load in between.
class RunPage {
public:
    /// Records the part of the run in the window. Throws UserError if the window is empty. The network is used only by
    /// the constructor.
    RunPage(const Network&, const TraceWindow&);

    TraceSink& sink() { return timeline_; }
    /// Returns the page. The critical path, if given, is a line through the timelines. REQUIRES: the run is over;
    /// called once.
    std::string html(const PageContent&, std::span<const PathPart> critical_path = {});
    /// Returns lines of text that tell the user what is missing on the page, and name the file. REQUIRES: the run is
    /// over.
    std::string warnings(const std::filesystem::path&) const;

private:
    Tracks tracks_;
    page::PageRecorder recorder_;
    Timeline timeline_;
};

} // namespace placedpar
