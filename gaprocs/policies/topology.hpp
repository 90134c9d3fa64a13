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

/// For each island the numbers of its neighbours, to which its emigrants may go. Islands are numbered from 0. A
/// sequential schedule sends to the neighbours in this order.
using Neighbours = std::vector<std::vector<std::size_t>>;

// Each policy returns the neighbours of each of `islands` islands. It leaves out the island itself and repeated
// neighbours, as in a torus of two columns. In all topologies except the star, the n-th neighbours of all islands are a
// permutation of the islands. So if every island sends to its n-th neighbour, each receives from one island. REQUIRES:
// islands >= 1. Throws UserError if the topology does not exist for this number of islands.

/// Connects each island to the next, and the last island to the first. With `ways` = 2 also connects each island to the
/// one before it.
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

/// Connects islands whose numbers differ in one binary digit: i xor 1, i xor 2, i xor 4, ... (thesis 5.3.2 has two
/// dimensions). The number of islands must be a power of two.
struct HypercubeTopology {
    static constexpr std::string_view
        name = "hypercube",
        about = "each island sends to the islands whose numbers differ from its own in one binary digit",
        source = "thesis 5.2.1 and 5.3.2";
    static constexpr std::tuple<> numbers() { return {}; }
    Neighbours operator()(std::size_t islands) const;
};

/// Connects the islands of a rectangle, which is closed in both directions, to the east, south, west and north. Island
/// i is in row i / columns and column i % columns.
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

/// Connects island 0 with each other island, in both directions.
struct StarTopology {
    static constexpr std::string_view
        name = "star",
        about = "island 0 exchanges with each other island; these do not exchange with each other",
        source = "not in the thesis";
    static constexpr std::tuple<> numbers() { return {}; }
    Neighbours operator()(std::size_t islands) const;
};

/// Connects each island to all others. Island i has the neighbours i + 1, i + 2, ..., then 0, 1, ... up to i - 1.
struct CompleteTopology {
    static constexpr std::string_view name = "complete",
                                      about = "each island sends to all others, beginning with the next",
                                      source = "thesis 5.3.2, broadcasting";
    static constexpr std::tuple<> numbers() { return {}; }
    Neighbours operator()(std::size_t islands) const;
};

struct NoTopology {
    static constexpr std::string_view name = "none", about = "islands exchange nothing",
                                      source = "a control for comparisons, not in the thesis";
    static constexpr std::tuple<> numbers() { return {}; }
    Neighbours operator()(std::size_t islands) const { return Neighbours(islands); }
};

/// Connects islands by a list. The list is not part of the policy's text, because a netlist's connections are its list.
/// An island may only send or only receive, but must do at least one of them.
struct GivenTopology {
    static constexpr std::string_view
        name = "given",
        about = "each island sends to the neighbours in a list; in a netlist, to the islands connected to it",
        source = "the netlist's connections";
    static constexpr std::tuple<> numbers() { return {}; }
    Neighbours neighbours;
    /// Throws UserError if the list is for another number of islands. Throws it also if a neighbour does not exist, is
    /// the island itself, or is listed twice.
    Neighbours operator()(std::size_t islands) const;
};

/// A user-defined struct with a call operator like those above. The lists that it returns are checked like those of
/// GivenTopology.
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
    /// Throws UserError, with what would be right, if there is no island or the topology does not exist for this number
    /// of islands. Throws it also if an island has no neighbours, except for the topology "none".
    Neighbours neighbours(std::size_t islands) const;
};

/// Returns for each island its distance from the island `from`: the number of exchanges in which individuals reach it,
/// if each island sends to all its neighbours. The distance is 0 for `from` itself, and absent if individuals never
/// arrive. REQUIRES: from < neighbours.size().
std::vector<std::optional<std::size_t>> distances(const Neighbours& neighbours, std::size_t from);

/// Returns the parts of the topology that do not exchange with each other. The islands of each part are in ascending
/// order, and so are the parts. A connected topology has one part.
std::vector<std::vector<std::size_t>> separate_parts(const Neighbours& neighbours);

/// Two islands of the same part, where individuals of the first never reach the second. An example is a one-way chain:
/// nothing from its end reaches its beginning. one_way() returns the first such pair.
struct OneWay {
    std::size_t from, never_to;
};
std::optional<OneWay> one_way(const Neighbours& neighbours);

} // namespace placedpar
