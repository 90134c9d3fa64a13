#pragma once

#include "observe/page/load_bins.hpp"
#include "observe/page/stretches.hpp"
#include "observe/trace/trace_writer.hpp"

#include <boost/json/fwd.hpp>

#include <span>
#include <string>
#include <vector>

namespace placedpar::page {

/// Keeps of a trace what a page of bounded size has room for: of every track how loaded it was, bin by bin, and every
/// slice and message, packed; where those are too many, the ones of the beginning and the end of the run.
class PageRecorder final : public TraceWriter {
public:
    /// REQUIRES: the tracks outlive it.
    PageRecorder(const Tracks&, Time from);

    void write(const Slice&) override;
    void write(const MessageArrow&) override;
    void draw_path(std::span<const PathPart>) override;
    void finish(Time begin, Time end, const std::string& why) override;

    /// Times in picoseconds. {"begin", "end", "why", "bin", "left_out": slices and messages, "lost": from when to when
    /// they are, "doing": names of what tracks do, "nodes", "tracks", "deflated", "stretches": [begin, end, slices and
    /// messages, ...], "texts": of the path, "path": [track, begin, how long, name, ...]}.
    /// REQUIRES: it is finished.
    boost::json::object json();
    /// In the same order; compressed if json() says so. REQUIRES: it is finished.
    const Stretches& stretches() const { return stretches_; }

private:
    boost::json::object track_json(std::size_t track) const;
    boost::json::array tracks_json() const;
    boost::json::array stretches_json() const;
    boost::json::array path_json(TextTable&) const;

    const Tracks& tracks_;
    LoadBins bins_;
    Stretches stretches_;
    std::vector<PathPart> path_; ///< where it is known; of a very long one the longest parts
    Time begin_{}, end_{};
    std::string why_;
};

} // namespace placedpar::page
