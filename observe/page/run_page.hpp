#pragma once

#include "netlist/run_report.hpp"
#include "observe/page/page_recorder.hpp"
#include "observe/trace/timeline.hpp"
#include "report/run_report.hpp"

#include <filesystem>
#include <span>
#include <string>

namespace placedpar {

/// What a page shows of a run beside its timelines.
struct PageContent {
    const Network& network;
    const RunReport& report;
    const Manifest& manifest;
    const GenerationLog& searches;
};

/// A run as one HTML file that is looked at in a browser, without the internet: the network, coloured by load at the
/// moment that a slider chooses, timelines, measures, a deadlock's cycle, convergence. It stays below 64 megabytes: of
/// a run that is too long for that it has every slice and message of the beginning and the end, and between them how
/// loaded everything was.
class RunPage {
public:
    /// The whole run, or what lies in the window; throws UserError when that is empty. The network is looked at only
    /// here.
    RunPage(const Network&, const TraceWindow&);

    TraceSink& sink() { return timeline_; }
    /// With the critical path as a line through the timelines, where it is known. REQUIRES: the run is over; called
    /// once.
    std::string html(const PageContent&, std::span<const PathPart> critical_path = {});
    /// What the user should know about what is not on it, in lines of text that name the file. REQUIRES: the run is
    /// over.
    std::string warnings(const std::filesystem::path&) const;

private:
    Tracks tracks_;
    page::PageRecorder recorder_;
    Timeline timeline_;
};

} // namespace placedpar
