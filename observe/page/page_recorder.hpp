#pragma once

#include "observe/page/load_bins.hpp"
#include "observe/page/stretches.hpp"
#include "observe/trace/trace_writer.hpp"

#include <boost/json/fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace placedpar::page {

/// Keeps the trace of a run for an HTML page of bounded size. It keeps the load of every track (the timeline of a
/// processor, process or link) in bins of time, and the slices (bars of the timelines) and messages. If there are too
/// many slices and messages, it keeps only those at the beginning and the end of the run.
class PageRecorder final : public TraceWriter {
public:
    /// REQUIRES: the tracks outlive this object.
    PageRecorder(const Tracks&, Time from);

    void write(const Slice&) override;
    void write(const MessageArrow&) override;
    void draw_path(std::span<const PathPart>) override;
    void finish(Time begin, Time end, const std::string& why) override;

    /// Returns {"begin", "end", "why", "bin": width of a bin, "left_out": number of slices and messages left out,
    /// "lost": [begin, end] of the interval without them, "doing": names of activities, "nodes", "tracks", "deflated",
    /// "stretches" (packed pieces of the trace): [begin, end, number of slices and messages, ...], "texts": texts of
    /// the path, "path": [track, begin, duration, name, ...]}. Times are in picoseconds. REQUIRES: finish() was called.
    boost::json::object json();
    /// Returns the contents of the stretches, in the order of json(). They are compressed if "deflated" is true.
    /// REQUIRES: finish() was called.
    const Stretches& stretches() const { return stretches_; }

private:
    boost::json::object track_json(std::size_t track) const;
    boost::json::array tracks_json() const;
    boost::json::array stretches_json() const;
    boost::json::array path_json(TextTable&) const;

    const Tracks& tracks_;
    LoadBins bins_;
    Stretches stretches_;
    std::vector<PathPart> path_; ///< parts of the critical path that have a track; only the longest parts of a very
                                 ///< long path
    Time begin_{}, end_{};
    std::string why_;
};

} // namespace placedpar::page
