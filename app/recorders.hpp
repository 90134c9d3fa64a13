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

/// The names of the files that show the course of a run.
struct RecordedFiles {
    std::string trace, page; ///< "": not written
    TraceWindow window = {};
};

/// Records a run of a network while it happens, and writes the RecordedFiles afterwards.
class Recorders {
public:
    /// Throws UserError if a file cannot be written. If `another` is not null, it receives all events, too.
    Recorders(const Network&, const RecordedFiles&, TraceSink* another = nullptr);

    /// Returns the object to which the run must send its events; null if nothing is recorded.
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
