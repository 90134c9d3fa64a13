#pragma once

#include "gaprocs/policies/policy.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <tuple>

namespace placedpar {

// Each way says to which of an island's neighbours its emigrants go at exchange 1, 2, 3, ... All islands exchange in
// the same generations: every `every`-th, from generation `every` on, the first of all being generation 1.

struct BroadcastSchedule {
    static constexpr std::string_view name = "broadcast", about = "every `every` generations to all neighbours at once";
    std::size_t every = 3;
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"every", &BroadcastSchedule::every, 1, 1e6}); }
    std::span<const std::size_t> operator()(std::uint64_t exchange, std::span<const std::size_t> neighbours) const;
};

/// The first neighbour at the first exchange, then the second, after the last again the first: in a hypercube of two
/// dimensions i xor 1 and i xor 2 alternately (thesis 5.3.2).
struct SequentialSchedule {
    static constexpr std::string_view name = "sequential",
                                      about = "every `every` generations to one neighbour, each in its turn";
    std::size_t every = 3;
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"every", &SequentialSchedule::every, 1, 1e6}); }
    std::span<const std::size_t> operator()(std::uint64_t exchange, std::span<const std::size_t> neighbours) const;
};

/// When emigrants leave, and to whom they go.
class Schedule : public OneOf<BroadcastSchedule, SequentialSchedule> {
public:
    using OneOf::OneOf;
    static Schedule named(std::string_view text) { return read<Schedule>(text); }

    /// Of an island's neighbours, those to whom its emigrants go when the given generation, counted from 1, has been
    /// evaluated.
    std::span<const std::size_t> destinations(std::uint64_t generation, std::span<const std::size_t> neighbours) const;
};

} // namespace placedpar
