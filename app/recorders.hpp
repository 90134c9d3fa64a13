#pragma once

#include "observe/page/run_page.hpp"
#include "observe/trace/trace_file.hpp"
#include "observe/trace/trace_fork.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace placedpar {

/// The files that show the course of a run.
struct RecordedFiles {
    std::string trace, page; ///< "": not written
    TraceWindow window = {};
};

/// Records a run while it happens, and writes the RecordedFiles afterwards.
class Recorders {
public:
    /// Throws UserError if a file cannot be written. `another`, if not null, receives all events as well.
    Recorders(const Network&, const RecordedFiles&, TraceSink* another = nullptr);

    /// Returns null if nothing is recorded.
    TraceSink* sink() { return fork_ ? &*fork_ : nullptr; }
    /// REQUIRES: the run is over.
    void finish(const PageContent&, std::span<const PathPart> critical_path = {});

private:
    std::filesystem::path page_path_;
    std::optional<TraceFile> trace_;
    std::optional<RunPage> page_;
    std::optional<TraceFork> fork_;
};

} // namespace placedpar
