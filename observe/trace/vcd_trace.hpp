#pragma once

#include "observe/trace/trace_writer.hpp"
#include "text/output_file.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace placedpar {

/// Writes a trace as a value change dump (IEEE 1364) for GTKWave and other viewers of waveforms. A processor has a wire
/// that is 1 while the processor is busy. A process has a wire for each activity; the wire is 1 while the process or a
/// component of its PARs has this activity. Each direction of a link has a wire that is 1 while the direction carries
/// bytes. Each node is a scope that contains a scope for each of its processes. Times are in picoseconds.
///
/// Changes are kept in memory until the end of the run and then sorted. This is necessary because a slice (an interval
/// of one activity) arrives when it ends, so slices do not arrive in the order of their beginnings.
class VcdTrace final : public TraceWriter {
public:
    /// REQUIRES: file and tracks outlive this object, and nothing has been written to the file.
    VcdTrace(OutputFile&, const Tracks&);

    void write(const Slice&) override;
    void write(const MessageArrow&) override {}
    void finish(Time begin, Time end, const std::string& why) override;

private:
    /// A change of the number of tracks (processes and components) that set the wire to 1. `by` is 1 or -1.
    struct Change {
        Time at;
        std::uint32_t wire;
        std::int32_t by;
    };
    using Changes = std::vector<Change>;
    struct Wire {
        std::int32_t tracks = 0; ///< number of tracks that set the wire to 1
        bool shown = false;      ///< last value in the file
        bool is_on() const { return tracks > 0; }
    };
    void declare();
    void declare(std::size_t track, Track::Kind, const std::string& name);
    void declare_wire(std::uint32_t number, const std::string& name);
    void write_changes(Time begin, Time end);
    Changes::const_iterator make_changes(Changes::const_iterator, Time until);
    Changes::const_iterator write_moment(Changes::const_iterator);
    static std::string value_change(std::uint32_t number, Wire&);

    OutputFile& file_;
    const Tracks& tracks_;
    Changes changes_;
    std::map<std::uint32_t, Wire> wires_; ///< key: number of the wire
};

} // namespace placedpar
