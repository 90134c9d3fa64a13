#pragma once

#include <array>
#include <cstddef>

namespace placedpar::identification {

/// Names the ways in which a link can deviate. A wrong compliance causes missing flow in proportion to the slope of the
/// pressure. A leak causes it in proportion to the pressure, also at rest after the valve has shut. An offset of the
/// spool, or a drift between voltage and spool, causes it only while oil flows through the valve. A leak before the
/// movement has a size of its own, since a leak can begin when the valve opens.
enum class FaultHypothesis : unsigned char { compliance, leak, offset, leak_before };

inline constexpr std::array<FaultHypothesis, 4> all_hypotheses{FaultHypothesis::compliance, FaultHypothesis::leak,
                                                               FaultHypothesis::offset, FaultHypothesis::leak_before};

/// One number per hypothesis, in the order of all_hypotheses, and one per pair of hypotheses: a matrix column by
/// column. Sources that compute with them include way_matrices.hpp.
using PerHypothesis = std::array<double, all_hypotheses.size()>;
using PerPairOfHypotheses = std::array<double, all_hypotheses.size() * all_hypotheses.size()>;

inline constexpr std::size_t index_of(FaultHypothesis way) { return static_cast<std::size_t>(way); }

} // namespace placedpar::identification
