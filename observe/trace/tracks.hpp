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

/// A line of the picture that a trace draws.
struct Track {
    /// Of a node, in the order in which they are drawn: what its processor executes; the processes that the netlist
    /// places on it; those of the machine that serve its links; what leaves it over each link; of a device with tracks
    /// of its own (DeviceKind::tracks), as of a bus, what occupies each of them.
    enum class Kind { processor, process, machine_process, link, bus };
    /// Where it is drawn: by node and kind, then as the netlist declares them; a process is followed by the components
    /// of its PARs.
    struct DrawingOrder {
        std::size_t node;
        Kind kind;
        std::size_t number;                  ///< of the process or connection
        std::vector<std::size_t> components; ///< {0, 1} for "master/0/1"; {1} for the direction from b to a
        auto operator<=>(const DrawingOrder&) const = default;
    };

    std::string name; ///< "t[0]", "master/0/1", "t[0].link[1] -> t[1].link[0]"
    DrawingOrder place;
    std::size_t outermost; ///< the number of the track of the process at the outermost level; of others, their own
};

/// The tracks of a run. A process has one for all its life; so has each component of its PARs, which it shares with
/// those that take the same place in a later PAR. Numbers of tracks are positions in all().
class Tracks {
public:
    explicit Tracks(const Network&);

    const std::vector<Track>& all() const { return tracks_; }
    const std::vector<std::string>& nodes() const { return nodes_; }
    /// Numbers of tracks in the order in which they are drawn.
    std::vector<std::size_t> drawn() const;

    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    /// The track of a process; made when it is new. `none` for one that serves a machine where no node executes it.
    std::size_t of(const Process&);
    /// Returns the track of a place: of a node's processor, a direction of a link, or a bus. `none` if there is no such
    /// place.
    std::size_t of_place(const std::string& name) const;

private:
    std::size_t add(std::string name, Track::DrawingOrder);
    void add_links(const Network&, std::size_t connection);
    void add_tracks_of(const Network&, std::size_t node);
    void number_as_drawn();
    void add_component(const Process&, const std::string& path);
    bool add_machine_process(const Process&, const std::string& path);

    std::vector<Track> tracks_;
    std::vector<std::string> nodes_; ///< with their types
    std::unordered_map<std::string, std::size_t> processes_, places_;
};

} // namespace placedpar
