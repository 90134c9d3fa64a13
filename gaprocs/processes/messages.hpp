#pragma once

#include "gaprocs/processes/share.hpp"
#include "gaprocs/search.hpp"
#include "gaprocs/search_problem.hpp"
#include "runtime/protocol.hpp"

#include <cstdint>
#include <memory>
#include <vector>

namespace placedpar {

/// The netlist states how many bytes each message has on the wire (thesis, appendix E: 148 bytes of measurements, 240
/// of strings, 240 of fitness), whatever this program's own data take. A word before the bytes says what they are and
/// how many: occam's counted array, whose count is an INT.
inline constexpr std::int64_t largest_message_bytes = 0x7fffffff;

/// Returns the length of a message of a number of strings, or fitnesses, and `others` bytes more. Throws UserError
/// above largest_message_bytes.
std::uint32_t message_bytes(std::size_t individuals, std::uint32_t bytes_each, std::uint32_t others = 0);

struct Parcel {
    std::uint32_t bytes = 0;
    WireForm wire_form() const { return WireForm(4u, bytes); }
};

/// From the host: a sample of the record, or the end of it.
struct HostMessage : Parcel {
    bool end = false;
    Sample sample;
    bool operator==(const HostMessage& other) const {
        return bytes == other.bytes && end == other.end && sample == other.sample;
    }
};

using Window = std::shared_ptr<const std::vector<Sample>>;

/// From a master to one of its slaves: evaluate these strings.
struct Task : Parcel {
    enum class Kind { evaluate, rehearse, end } kind = Kind::end;
    std::size_t slave = 0;   ///< the addressee, counted from the master
    std::size_t master = 0;  ///< the master that sent it, among those that share the slaves
    std::size_t address = 0; ///< 0: the slave that receives it; else one beyond, in the order of SlaveRoutes
    Share share;
    std::vector<Genome> strings; ///< the individuals that the share touches
    Window window;               ///< the measurements where they are new; null where the slave has them
    double bias = 0;
    Coding coding = Coding::natural; ///< how the strings are to be read
    bool results_in_order = false;   ///< the farthest slave's first in each round; else as they become ready
    std::size_t tasks_under_way = 1; ///< that the master may have sent the addressee before the first is answered
};

/// From a slave to its master: what the share adds to the fitness of each individual that it touches.
struct Fitnesses : Parcel {
    bool end = false;                  ///< the answer to Task::Kind::end
    std::size_t slave = 0, master = 0; ///< of the task
    std::size_t hops = 0;              ///< slaves that have passed it on
    Share share;
    std::vector<double> terms;
};

/// A message between two processes of one processor, which share its memory: only its address is passed.
template <class T>
struct InPlace {
    T message;
    WireForm wire_form() const { return WireForm(4u); }
};

/// From an island to a neighbour.
struct Emigrants : Parcel {
    bool end = false; ///< the island has ended; only where it does not exchange in step
    std::uint64_t generation = 0;
    std::vector<Individual> individuals;
};

/// From a search to its host, after the generations of each sample, and from an island to the analyst of all, each time
/// that it exchanges.
struct EstimateMessage : Parcel {
    bool end = false; ///< the search has ended
    std::uint64_t generation = 0;
    std::size_t samples = 0; ///< that it has been sent until then
    Individual best;
};

/// From a coarse search to a fine one: where it is to search.
struct BiasPoint : Parcel {
    Genome string; ///< of the problem
};

} // namespace placedpar
