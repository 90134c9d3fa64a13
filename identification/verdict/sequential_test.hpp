#pragma once

#include "identification/verdict/deviation.hpp"

#include <array>
#include <cstddef>
#include <optional>

namespace placedpar::identification {

/// Names the possible faults of a link. A `leak` exists before and during a movement; a `new_leak` begins when the
/// valve opens.
enum class LinkFault : unsigned char { compliance, leak, new_leak, offset };

inline constexpr std::array<LinkFault, 4> all_faults{LinkFault::compliance, LinkFault::leak, LinkFault::new_leak,
                                                     LinkFault::offset};

/// Returns the deviations that one unit of a fault causes.
PerHypothesis unit_of(LinkFault fault);

/// A suspected fault of a link, and its size with sign in the units of WayUnits (deviation.hpp). One unit is a size
/// that a verdict should detect. A leak is always positive.
struct Suspicion {
    LinkFault fault;
    double units;
};

/// Tests movement by movement whether a link deviates from its reference, a healthy state, with Page's cumulative sums
/// (Biometrika 41, 1954). Each suspicion has a sum. Each movement adds to the sum the logarithm of the likelihood ratio
/// of the suspected deviation to no deviation. A sum is never below 0. One movement adds at most `most_of_one`, because
/// real errors have longer tails than the normal distribution. If it would add more, its information is reduced in
/// proportion. Therefore a report needs at least two movements. The reference is uncertain too. Therefore a sum s
/// counts as s / (1 + I b), where I is the information of the movements in the sum, and b is the variance of the
/// reference.
class SequentialTest {
public:
    static constexpr std::array<Suspicion, 6> suspicions{{{LinkFault::compliance, 1},
                                                          {LinkFault::compliance, -1},
                                                          {LinkFault::leak, 1},
                                                          {LinkFault::new_leak, 1},
                                                          {LinkFault::offset, 1},
                                                          {LinkFault::offset, -1}}};
    static constexpr double most_of_one = 6;
    /// The limit at which a fault is reported. A false report then occurs at most once in e^7 = 1100 movements per
    /// suspicion (G. Lorden, Annals of Mathematical Statistics 42, 1971). For rates on simulated machines see
    /// examples/hydraulics/faults.
    static constexpr double raised_at = 7;
    /// The greatest value of a sum, so that three movements can return it to 0. A suspicion is dropped when its sum
    /// returns to 0.
    static constexpr double most = 13;

    /// Holds everything that is needed to restore the object.
    struct State {
        std::array<double, suspicions.size()> sums{};
        std::array<double, suspicions.size()> informations{}; ///< information of the movements since the sum was last 0
        bool raised = false;
        PerHypothesis pull{}; ///< information times deviation, summed over the movements since all sums were 0
        PerPairOfHypotheses information{}; ///< information of these movements
        std::size_t movements = 0;         ///< number of these movements

        friend bool operator==(const State&, const State&) = default;
    };

    SequentialTest() = default;
    explicit SequentialTest(const State& state) : state_(state) {}
    const State& state() const { return state_; }
    friend bool operator==(const SequentialTest&, const SequentialTest&) = default;

    /// Adds a movement. The tested deviation is `movement` minus the reference `from`. `scale` states how many units of
    /// each hypothesis are suspected.
    void take(const Deviation& movement, const Deviation& from, const PerHypothesis& scale = {1, 1, 1, 1});
    bool raised() const { return state_.raised; }
    /// Returns the mean of the movements since all sums were 0, weighted by information; nullopt if there are none.
    std::optional<Deviation> mean() const;

private:
    /// Adds the movement to the sum of one suspicion. Returns s / (1 + I b) for this sum.
    double add(std::size_t suspicion, const PerHypothesis& seen, const PerPairOfHypotheses& information,
               const PerPairOfHypotheses& from_covariance, const PerHypothesis& scale);

    State state_;
};

} // namespace placedpar::identification
