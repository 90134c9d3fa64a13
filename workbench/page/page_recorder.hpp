#pragma once

#include "workbench/page/both_ends.hpp"
#include "workbench/page/load_bins.hpp"
#include "workbench/trace/trace_writer.hpp"

#include <boost/json.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace placedpar::page {

/// Numbers texts in the order in which they first come; the empty one is 0.
class TextTable {
public:
    TextTable() { number_of(""); }
    std::uint32_t number_of(const std::string& text);
    boost::json::array json() const;

private:
    std::unordered_map<std::string, std::uint32_t> numbers_;
    std::vector<std::string> texts_;
};

/// Keeps of a trace what a page of bounded size has room for: of every track how loaded it was, bin by bin, and of the
/// beginning and the end of the run every slice and message.
class PageRecorder final : public TraceWriter {
public:
    /// REQUIRES: the tracks outlive it.
    PageRecorder(const Tracks&, Time from);

    void write(const Slice&) override;
    void write(const Passage&) override;
    void draw_path(std::span<const PathMark>) override;
    void finish(Time begin, Time end, const std::string& why) override;

    /// Times in picoseconds. {"begin", "end", "why", "bin", "left_out": slices and messages, "doing": names of what
    /// tracks do, "texts", "nodes", "tracks", "messages": [track, track, left, how long, channel, ...], "path": [track,
    /// begin, how long, name, ...]}.
    /// REQUIRES: it is finished.
    boost::json::object json();

private:
    struct KeptSlice {
        std::uint32_t track, note;
        std::uint8_t doing;
        bool open;
        Time begin, end;
    };
    struct KeptPassage {
        std::uint32_t from, to, channel;
        Time left, arrived;
    };
    std::uint32_t note_of(const Slice&);
    boost::json::object track_json(std::size_t track, const std::vector<const KeptSlice*>&, std::size_t first) const;
    boost::json::array tracks_json() const;
    boost::json::array messages_json() const;
    boost::json::array path_json();

    const Tracks& tracks_;
    LoadBins bins_;
    BothEnds<KeptSlice> slices_;
    BothEnds<KeptPassage> passages_;
    TextTable texts_;
    std::vector<PathMark> path_; ///< where it is known; of a very long one the longest parts
    Time begin_{}, end_{};
    std::string why_;
};

} // namespace placedpar::page
