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

// Each way says to which of an island's neighbours its emigrants go at exchange 1, 2, 3, ... Islands exchange in their
// generations `every`, 2 `every`, 3 `every`, ..., the first of all being generation 1.

struct BroadcastSchedule {
    static constexpr std::string_view name = "broadcast", about = "every `every` generations to all neighbours at once",
                                      source = "thesis 5.3.2; every third generation: 4.3";
    std::size_t every = 3;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"every", &BroadcastSchedule::every, 1, 1e6, "generations"});
    }
    std::span<const std::size_t> operator()(std::uint64_t exchange, std::span<const std::size_t> neighbours) const;
};

/// Sends to the first neighbour at the first exchange, then to the second, and after the last to the first again: in a
/// hypercube of two dimensions i xor 1 and i xor 2 alternately (thesis 5.3.2).
struct SequentialSchedule {
    static constexpr std::string_view name = "sequential",
                                      about = "every `every` generations to one neighbour, each in its turn",
                                      source = "thesis 5.2.1 and 5.3.2";
    std::size_t every = 3;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"every", &SequentialSchedule::every, 1, 1e6, "generations"});
    }
    std::span<const std::size_t> operator()(std::uint64_t exchange, std::span<const std::size_t> neighbours) const;
};

/// No island waits for another: emigrants go to all neighbours, and an island accepts those that have arrived, from
/// each neighbour only the last sent. On a simulated machine this depends on its times, and is the same in every run.
struct AsynchronousSchedule {
    static constexpr std::string_view name = "asynchronous",
                                      about = "every `every` generations to all neighbours, waiting for none",
                                      source = "not in the thesis";
    std::size_t every = 3;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"every", &AsynchronousSchedule::every, 1, 1e6, "generations"});
    }
    std::span<const std::size_t> operator()(std::uint64_t exchange, std::span<const std::size_t> neighbours) const;
};

/// A struct of a program's own that has `every`, its first number, and a call operator as those above, which depends on
/// nothing but what it is given: both ends of a channel ask it. The neighbours that it gives stand together in the
/// list. Islands that exchange wait for each other.
class OwnSchedule : public OwnPolicy {
public:
    template <class Policy>
    explicit OwnSchedule(Policy policy) : OwnPolicy(policy), every(policy.every), choose_(policy) {
        tried([&] {
            require(every > 0 && !numbers().empty() && description().numbers.front().name == "every",
                    "the first number of a schedule is `every`, 1 or more");
        });
    }
    std::size_t every;
    std::span<const std::size_t> operator()(std::uint64_t exchange, std::span<const std::size_t> neighbours) const;

private:
    std::function<std::span<const std::size_t>(std::uint64_t, std::span<const std::size_t>)> choose_;
};

/// The policy that says when emigrants leave, and to which neighbours.
class Schedule : public OneOf<Schedule, BroadcastSchedule, SequentialSchedule, AsynchronousSchedule, OwnSchedule> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "schedule",
                                      about = "when emigrants leave an island, and to which neighbours they go";

    /// Whether islands that exchange wait for each other, so that all are in the same generation.
    bool in_step() const { return !std::holds_alternative<AsynchronousSchedule>(policy()); }
    /// Whether emigrants go to one neighbour after the other, not always to all.
    bool takes_turns() const { return std::holds_alternative<SequentialSchedule>(policy()); }
    /// Returns whether a program added it; then it is not known when its turns begin anew.
    bool is_own() const { return std::holds_alternative<OwnSchedule>(policy()); }
    /// Whether an exchange follows the evaluation of the given generation, counted from 1.
    bool is_due(std::uint64_t generation) const { return generation > 0 && generation % every() == 0; }
    /// Returns the number of generations from one exchange to the next.
    std::size_t every() const {
        return std::visit([](const auto& way) { return way.every; }, policy());
    }

    /// Returns the neighbours to which an island's emigrants go after the given generation, counted from 1, has been
    /// evaluated.
    std::span<const std::size_t> destinations(std::uint64_t generation, std::span<const std::size_t> neighbours) const;
};

/// Returns for each island the largest number of islands from which immigrants arrive at once. With a program's own
/// schedule, these are all islands of which it is a neighbour. Looks at 10 000 exchanges, in which every coincidence of
/// the turns occurs unless islands have very odd numbers of neighbours. REQUIRES: neighbours as Topology::neighbours()
/// gives them.
std::vector<std::size_t> most_senders_at_once(const Schedule&, const Neighbours&);

} // namespace placedpar
