#pragma once

#include "gaprocs/policies/policy.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

namespace placedpar {

/// For each island, the numbers of the islands to which it may send emigrants. Islands are numbered from 0. The order
/// matters to a sequential schedule, which sends to one neighbour after another.
using Neighbours = std::vector<std::vector<std::size_t>>;

// Each policy below returns the neighbours of each of `islands` islands. An island is never its own neighbour, and has
// no neighbour twice. In a torus of two columns, for example, the east and the west neighbour are the same island,
// which is listed once. In the ring, the hypercube, the torus and the complete topology, no two islands have the same
// n-th neighbour. So if every island sends to its n-th neighbour, each island receives from one island. REQUIRES:
// islands >= 1. Throws UserError if there is no such topology of `islands` islands.

/// Connects each island to the next, and the last to the first. If `ways` is 2, also connects each island to the
/// previous one, and the first to the last.
struct RingTopology {
    static constexpr std::string_view name = "ring",
                                      about =
                                          "each island sends to the next; with ways = 2 also to the preceding island",
                                      source = "thesis, appendix E";
    std::size_t ways = 1;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"ways", &RingTopology::ways, 1, 2,
                                       "1: sends to the next island; 2: also to the preceding island"});
    }
    Neighbours operator()(std::size_t islands) const;
};

/// Connects islands whose numbers differ in one binary digit: i xor 1, i xor 2, i xor 4, ... (the thesis has two
/// dimensions, 5.3.2). The number of islands must be a power of two.
struct HypercubeTopology {
    static constexpr std::string_view
        name = "hypercube",
        about = "each island sends to the islands whose numbers differ from its own in one binary digit",
        source = "thesis 5.2.1 and 5.3.2";
    Neighbours operator()(std::size_t islands) const;
};

/// Connects each island of a rectangle to its neighbours in the east, south, west and north, in this order. At an edge,
/// the neighbour is at the opposite edge. Island i is in row i / columns and column i % columns.
struct TorusTopology {
    static constexpr std::string_view
        name = "torus",
        about =
            "a rectangle closed in both directions: each island sends to its neighbours east, south, west and north",
        source = "not in the thesis";
    std::size_t rows = 2;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"rows", &TorusTopology::rows, 1, 1e6,
                                       "rows of islands; the number of columns is islands / rows"});
    }
    Neighbours operator()(std::size_t islands) const;
};

/// Connects island 0 with every other island, in both directions.
struct StarTopology {
    static constexpr std::string_view
        name = "star",
        about = "island 0 exchanges with every other island; the other islands exchange only with island 0",
        source = "not in the thesis";
    Neighbours operator()(std::size_t islands) const;
};

/// Connects each island to all others. Island i has the neighbours i + 1, i + 2, ..., then 0, 1, ... up to i - 1.
struct CompleteTopology {
    static constexpr std::string_view name = "complete",
                                      about = "each island sends to all others, beginning with the next",
                                      source = "thesis 5.3.2, broadcasting";
    Neighbours operator()(std::size_t islands) const;
};

struct NoTopology {
    static constexpr std::string_view name = "none", about = "islands exchange nothing",
                                      source = "a control for comparisons, not in the thesis";
    Neighbours operator()(std::size_t islands) const { return Neighbours(islands); }
};

/// Connects islands as listed in `neighbours`. The policy's text does not contain the list, because in a netlist the
/// connections define it. An island may send without receiving, or receive without sending.
struct GivenTopology {
    static constexpr std::string_view
        name = "given",
        about = "each island sends to the neighbours in a list; in a netlist, to the islands connected to it",
        source = "the netlist's connections";
    Neighbours neighbours;
    /// Throws UserError if `neighbours` is for another number of islands, or if a neighbour does not exist, is the
    /// island itself, or is listed twice.
    Neighbours operator()(std::size_t islands) const;
};

/// A user-defined struct with the same call operator as the policies above. The returned neighbours are checked like
/// the list of a GivenTopology.
class OwnTopology : public OwnPolicy {
public:
    template <class Policy>
    explicit OwnTopology(Policy policy) : OwnPolicy(policy), neighbours_(std::move(policy)) {}
    Neighbours operator()(std::size_t islands) const {
        return tried([&] { return GivenTopology{neighbours_(islands)}(islands); });
    }

private:
    std::function<Neighbours(std::size_t)> neighbours_;
};

/// The policy that says which islands exchange individuals.
class Topology : public OneOf<Topology, RingTopology, HypercubeTopology, TorusTopology, StarTopology, CompleteTopology,
                              NoTopology, GivenTopology, OwnTopology> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "topology", about = "which islands exchange individuals";

    bool is_given() const { return std::holds_alternative<GivenTopology>(policy()); }
    /// Returns whether islands exchange individuals: false for "none".
    bool exchanges() const { return !std::holds_alternative<NoTopology>(policy()); }
    /// Throws UserError if `islands` is 0, if there is no such topology of `islands` islands, or if an island neither
    /// sends nor receives. In the topology "none", islands may do neither. The message says what would be right.
    Neighbours neighbours(std::size_t islands) const;
};

/// Returns the distance of each island from the island `from`. The distance is the number of exchanges after which an
/// individual can have moved from island `from` to this island, if each island sends to all its neighbours. There is no
/// distance to an island that individuals of `from` never reach. REQUIRES: from < neighbours.size().
std::vector<std::optional<std::size_t>> distances(const Neighbours& neighbours, std::size_t from);

/// Returns the connected parts of the topology: groups of islands between which no individual moves. The parts are
/// ordered by their first islands. The islands of each part are in ascending order.
std::vector<std::vector<std::size_t>> separate_parts(const Neighbours& neighbours);

/// Two islands of the same connected part, where individuals of island `from` never reach island `never_to`. In a chain
/// that sends only forwards, for example, no individual moves from the end to the beginning. one_way() returns such a
/// pair, if there is one.
struct OneWay {
    std::size_t from, never_to;
};
std::optional<OneWay> one_way(const Neighbours& neighbours);

} // namespace placedpar
