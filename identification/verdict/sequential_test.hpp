#pragma once

#include "identification/verdict/deviation.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace placedpar::identification {

/// What can be wrong with a link: a way that it is off in, or a leak that begins when the valve opens.
enum class LinkFault : unsigned char { compliance, leak, new_leak, offset };

inline constexpr std::array<LinkFault, 4> all_faults{LinkFault::compliance, LinkFault::leak, LinkFault::new_leak,
                                                     LinkFault::offset};

/// The size of each way that one unit of a fault has.
PerHypothesis unit_of(LinkFault fault);

/// What is suspected: a link has one fault, in one sense. A leak takes only.
struct Suspicion {
    LinkFault fault;
    double units;
};

/// Tests one after the other whether a link has left a deviation, Page's cumulative sums (Biometrika 41, 1954): for
/// each suspicion the logarithm of the likelihood of the suspected deviation over that of none, added up over the
/// movements, never below 0. One movement says no more than `most_of_one`, since errors that are not normal have
/// longer tails than the likelihood knows, and counts as so much less information; so it takes two at least. What the
/// link is compared with is not known exactly: of a sum s over movements of information I that is worth
/// s / (1 + I b), b the variance of what it is compared with.
class SequentialTest {
public:
    static constexpr std::array<Suspicion, 6> suspicions{{{LinkFault::compliance, 1},
                                                          {LinkFault::compliance, -1},
                                                          {LinkFault::leak, 1},
                                                          {LinkFault::new_leak, 1},
                                                          {LinkFault::offset, 1},
                                                          {LinkFault::offset, -1}}};
    static constexpr double most_of_one = 6;
    /// Nothing that is suspected is raised wrongly more often than once in e^7 = 1100 movements (G. Lorden, Annals of
    /// Mathematical Statistics 42, 1971); the rates of machines: examples/hydraulics/faults.
    static constexpr double raised_at = 7;
    /// A suspicion is dropped when its sum is back at 0, and none is worth more than this: three movements clear it.
    static constexpr double most = 13;

    /// All that a restart needs.
    struct State {
        std::array<double, suspicions.size()> sums{};
        std::array<double, suspicions.size()> informations{}; ///< of the movements since the sum was 0
        bool raised = false;
        PerHypothesis pull{};              ///< information times deviation, of the movements since all sums were 0
        PerPairOfHypotheses information{}; ///< of them
        std::size_t movements = 0;         ///< so many

        friend bool operator==(const State&, const State&) = default;
    };

    SequentialTest() = default;
    explicit SequentialTest(const State& state) : state_(state) {}
    const State& state() const { return state_; }
    friend bool operator==(const SequentialTest&, const SequentialTest&) = default;

    /// One more movement: how far off the link was, beyond `from`, in units; `scale` of them are suspected of each way.
    void take(const Deviation& movement, const Deviation& from, const PerHypothesis& scale = {1, 1, 1, 1});
    bool raised() const { return state_.raised; }
    /// The mean of the movements that count, each weighted by its information; none before one does.
    std::optional<Deviation> mean() const;

private:
    /// One suspicion's share of take(); what its sum is worth then.
    double add(std::size_t suspicion, const PerHypothesis& seen, const PerPairOfHypotheses& information,
               const PerPairOfHypotheses& from_covariance, const PerHypothesis& scale);

    State state_;
};

} // namespace placedpar::identification
