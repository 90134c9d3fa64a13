#pragma once

#include "netlist/network/network.hpp"
#include "runtime/process.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace placedpar {

struct ProgramTurn; // runtime/trace.hpp

/// The timeline of a processor, process, link or bus: a line of a drawn trace.
struct Track {
    /// The kinds of tracks of a node, in drawing order: its processor; the processes that the netlist places on it; the
    /// processes of the program with which it is booted; the machine's processes that serve its links; each link, in
    /// the direction that leaves the node; a device's own tracks (DeviceKind::tracks), such as the track of a bus.
    enum class Kind { processor, process, program, machine_process, link, bus };
    /// Orders tracks by node and kind, then as the netlist declares them. A process is followed by the components of
    /// its PARs.
    struct DrawingOrder {
        std::size_t node;
        Kind kind;
        std::size_t number; ///< index of the process or connection
        /// {0, 1} for "master/0/1"; for a wire from a to b: {1} for the direction from b to a.
        std::vector<std::size_t> components;
        auto operator<=>(const DrawingOrder&) const = default;
    };

    std::string name; ///< "t[0]", "master/0/1", "t[0].link[1] -> t[1].link[0]"
    DrawingOrder place;
    /// For a component of a PAR, the track of its outermost process; otherwise the track's own number.
    std::size_t outermost;
};

/// Holds the tracks of a run. A process has one track for its whole life. A component of a PAR also has a track. The
/// components of the same position in later PARs use the same track. Numbers of tracks are positions in all().
class Tracks {
public:
    explicit Tracks(const Network&);

    const std::vector<Track>& all() const { return tracks_; }
    const std::vector<std::string>& nodes() const { return nodes_; }
    /// Returns the numbers of the tracks in drawing order.
    std::vector<std::size_t> drawn() const;

    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    /// Returns the track of a process, and makes it if it is new. Returns `none` for a process of the machine that no
    /// node executes.
    std::size_t of(const Process&);
    /// Returns the track of a process of a booted program, and makes it if it is new.
    std::size_t of(const ProgramTurn&);
    /// Returns the track of a node's processor, of a direction of a link, or of a bus. Returns `none` if nothing has
    /// this name.
    std::size_t of_place(const std::string& name) const;

private:
    std::size_t add(std::string name, Track::DrawingOrder);
    void add_links(const Network&, std::size_t connection);
    void add_tracks_of(const Network&, std::size_t node);
    void number_as_drawn();
    void add_component(const Process&, const std::string& path);
    std::size_t of_program(const std::string& process, const std::string& processor);
    bool add_machine_process(const Process&, const std::string& path);

    std::vector<Track> tracks_;
    std::vector<std::string> nodes_; ///< names with types
    std::unordered_map<std::string, std::size_t> processes_, places_;
};

} // namespace placedpar
