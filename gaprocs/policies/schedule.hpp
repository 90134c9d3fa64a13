#pragma once

#include "gaprocs/policies/policy.hpp"
#include "gaprocs/policies/topology.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

namespace placedpar {

// Each policy below says to which of an island's neighbours its emigrants go at a given exchange. The neighbours are
// the islands to which the topology allows the island to send. Exchanges and generations are numbered from 1. Exchange
// n follows generation n * `every`.

struct BroadcastSchedule {
    static constexpr std::string_view name = "broadcast",
                                      about = "every `every` generations emigrants go to all neighbours at once",
                                      source = "thesis 5.3.2; every third generation: 4.3";
    std::size_t every = 3;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"every", &BroadcastSchedule::every, 1, 1e6, "generations"});
    }
    std::span<const std::size_t> operator()(std::uint64_t exchange, std::span<const std::size_t> neighbours) const;
};

/// Sends to the first neighbour at the first exchange, to the second neighbour at the second exchange, and so on; after
/// the last neighbour, the first neighbour follows again. In a hypercube of two dimensions, island i has the neighbours
/// i xor 1 and i xor 2 (thesis 5.3.2).
struct SequentialSchedule {
    static constexpr std::string_view
        name = "sequential",
        about = "every `every` generations emigrants go to one neighbour, the next in the list each time",
        source = "thesis 5.2.1 and 5.3.2";
    std::size_t every = 3;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"every", &SequentialSchedule::every, 1, 1e6, "generations"});
    }
    std::span<const std::size_t> operator()(std::uint64_t exchange, std::span<const std::size_t> neighbours) const;
};

/// Sends to all neighbours; no island waits for another. An island accepts the emigrants that have arrived. If
/// emigrants of several exchanges have arrived from one neighbour, the island accepts only the latest. Which emigrants
/// have arrived depends only on simulated times, so it is the same in every run.
struct AsynchronousSchedule {
    static constexpr std::string_view
        name = "asynchronous",
        about = "every `every` generations emigrants go to all neighbours, and no island waits for another",
        source = "not in the thesis";
    std::size_t every = 3;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"every", &AsynchronousSchedule::every, 1, 1e6, "generations"});
    }
    std::span<const std::size_t> operator()(std::uint64_t exchange, std::span<const std::size_t> neighbours) const;
};

/// A user-defined struct with the same call operator as the policies above. Its first number is `every`, the
/// generations from one exchange to the next. The call operator returns a contiguous part of the list of neighbours.
/// The result may depend only on the arguments, because both the sending and the receiving island call the operator.
/// Islands that exchange wait for each other.
class OwnSchedule : public OwnPolicy {
public:
    template <class Policy>
    explicit OwnSchedule(Policy policy) : OwnPolicy(policy), every(policy.every), choose_(policy) {
        tried([&] {
            require(every > 0 && !numbers().empty() && description().numbers.front().name == "every",
                    "the first number of a schedule must be `every`, and at least 1");
        });
    }
    std::size_t every;
    std::span<const std::size_t> operator()(std::uint64_t exchange, std::span<const std::size_t> neighbours) const;

private:
    std::function<std::span<const std::size_t>(std::uint64_t, std::span<const std::size_t>)> choose_;
};

/// The policy that says when emigrants leave an island, and to which neighbours they go.
class Schedule : public OneOf<Schedule, BroadcastSchedule, SequentialSchedule, AsynchronousSchedule, OwnSchedule> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "schedule",
                                      about = "when emigrants leave an island, and to which neighbours they go";

    /// Returns whether islands that exchange wait for each other, so that all are in the same generation.
    bool in_step() const { return !std::holds_alternative<AsynchronousSchedule>(policy()); }
    /// Returns whether the schedule is sequential: emigrants go to one neighbour at each exchange.
    bool takes_turns() const { return std::holds_alternative<SequentialSchedule>(policy()); }
    /// Returns whether the schedule is user-defined. The destinations of a user-defined schedule cannot be known in
    /// advance.
    bool is_own() const { return std::holds_alternative<OwnSchedule>(policy()); }
    /// Returns whether an exchange follows the evaluation of the given generation.
    bool is_due(std::uint64_t generation) const { return generation > 0 && generation % every() == 0; }
    /// Returns the number of generations from one exchange to the next.
    std::size_t every() const {
        return std::visit([](const auto& way) { return way.every; }, policy());
    }

    /// Returns the neighbours to which an island's emigrants go after the evaluation of the given generation; none if
    /// no exchange is due.
    std::span<const std::size_t> destinations(std::uint64_t generation, std::span<const std::size_t> neighbours) const;
};

/// Returns for each island the largest number of islands that send to it in one exchange, because its population must
/// have room for their emigrants. With a user-defined schedule, counts all islands that have the island as a neighbour.
/// Tries at most 10 000 exchanges of a sequential schedule. If the schedule repeats only after more exchanges, the
/// result may be too low. REQUIRES: neighbours as returned by Topology::neighbours().
std::vector<std::size_t> most_senders_at_once(const Schedule&, const Neighbours&);

} // namespace placedpar
