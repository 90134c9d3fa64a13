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

/// The islands to which each island's emigrants may go, by number from 0, in the order in which a sequential schedule
/// takes them.
using Neighbours = std::vector<std::vector<std::size_t>>;

// Each policy returns the neighbours of `islands` islands. A neighbour that is the island itself, or is listed already
// (as in a torus of two columns), is left out. In all topologies except the star, the n-th neighbours of all islands
// are a permutation of the islands: if all send to their n-th neighbour, each receives from one island. REQUIRES:
// islands >= 1. Throws UserError for a number of islands that does not fit.

/// Connects each island to the next, and the last to the first; with 2 ways also to the one before.
struct RingTopology {
    static constexpr std::string_view name = "ring", about = "to the next island; with 2 ways also to the one before",
                                      source = "thesis, appendix E";
    std::size_t ways = 1;
    static constexpr auto numbers() {
        return std::tuple(
            PolicyNumber{"ways", &RingTopology::ways, 1, 2, "1: to the next island; 2: to the one before as well"});
    }
    Neighbours operator()(std::size_t islands) const;
};

/// The islands whose number differs in one binary digit: i xor 1, i xor 2, i xor 4, ... (thesis 5.3.2 has two
/// dimensions). A power of two of islands.
struct HypercubeTopology {
    static constexpr std::string_view name = "hypercube", about = "to those whose number differs in one binary digit",
                                      source = "thesis 5.2.1 and 5.3.2";
    static constexpr std::tuple<> numbers() { return {}; }
    Neighbours operator()(std::size_t islands) const;
};

/// Island i stands in row i / columns and column i % columns of a rectangle closed in both directions: to the east,
/// south, west, north.
struct TorusTopology {
    static constexpr std::string_view name = "torus", about = "a closed rectangle, to the east, south, west and north",
                                      source = "not in the thesis";
    std::size_t rows = 2;
    static constexpr auto numbers() {
        return std::tuple(
            PolicyNumber{"rows", &TorusTopology::rows, 1, 1e6, "of islands; as many columns as there are islands for"});
    }
    Neighbours operator()(std::size_t islands) const;
};

/// Island 0 to 1, 2, 3, ...; all others to island 0.
struct StarTopology {
    static constexpr std::string_view name = "star", about = "island 0 with all others, which have only that one",
                                      source = "not in the thesis";
    static constexpr std::tuple<> numbers() { return {}; }
    Neighbours operator()(std::size_t islands) const;
};

/// All others, from the next on: i + 1, i + 2, ... and after the last island from the first on.
struct CompleteTopology {
    static constexpr std::string_view name = "complete", about = "to all others, from the next on",
                                      source = "thesis 5.3.2, broadcasting";
    static constexpr std::tuple<> numbers() { return {}; }
    Neighbours operator()(std::size_t islands) const;
};

struct NoTopology {
    static constexpr std::string_view name = "none", about = "no exchange", source = "a control: not in the thesis";
    static constexpr std::tuple<> numbers() { return {}; }
    Neighbours operator()(std::size_t islands) const { return Neighbours(islands); }
};

/// Connects islands as listed. The list is not part of the policy's text: a netlist lists neighbours by its
/// connections. An island may only send or only receive, but must do one of them.
struct GivenTopology {
    static constexpr std::string_view name = "given", about = "neighbours as they are listed",
                                      source = "as a netlist connects islands";
    static constexpr std::tuple<> numbers() { return {}; }
    Neighbours neighbours;
    /// Throws UserError: lists of another number of islands, a neighbour that does not exist, is the island itself or
    /// is listed twice.
    Neighbours operator()(std::size_t islands) const;
};

/// A struct of a program's own with a call operator as those above: what it gives is checked as GivenTopology's lists.
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
    /// False for "none".
    bool exchanges() const { return !std::holds_alternative<NoTopology>(policy()); }
    /// Throws UserError, saying what would be right: no island, a number of islands that does not fit, an island
    /// without neighbours in any topology but "none".
    Neighbours neighbours(std::size_t islands) const;
};

/// Returns for each island the number of exchanges after which individuals of the island `from` can have reached it, if
/// each island sends to all its neighbours: 0 for the island itself, nothing if they never reach it. REQUIRES: from <
/// neighbours.size().
std::vector<std::optional<std::size_t>> distances(const Neighbours& neighbours, std::size_t from);

/// Returns the parts of the topology that exchange nothing with each other, each part and the parts in ascending order.
/// A single part: the topology is connected.
std::vector<std::vector<std::size_t>> separate_parts(const Neighbours& neighbours);

/// Two islands of one part, where nothing of the first ever reaches the second, as from the end of a chain of one way
/// to its beginning: the first such pair.
struct OneWay {
    std::size_t from, never_to;
};
std::optional<OneWay> one_way(const Neighbours& neighbours);

} // namespace placedpar
