#pragma once

#include <array>
#include <cstddef>

namespace placedpar::identification {

/// In what way a link can be off. A compliance that is too great or small misses flow in step with the slope of the
/// pressure, up while it rises and down while it falls; a leak in step with the pressure, also at rest after the valve
/// has shut; an offset of the spool, or a drift of voltage against spool, only while oil flows through the valve. A
/// leak before the movement is a size of its own, since a leak can begin when the valve opens.
enum class FaultHypothesis : unsigned char { compliance, leak, offset, leak_before };

inline constexpr std::array<FaultHypothesis, 4> all_hypotheses{FaultHypothesis::compliance, FaultHypothesis::leak,
                                                               FaultHypothesis::offset, FaultHypothesis::leak_before};

/// A size of each way, in the order of all_hypotheses; and what two of them have in common, a matrix column by column.
/// What computes with them includes way_matrices.hpp.
using PerHypothesis = std::array<double, all_hypotheses.size()>;
using PerPairOfHypotheses = std::array<double, all_hypotheses.size() * all_hypotheses.size()>;

inline constexpr std::size_t index_of(FaultHypothesis way) { return static_cast<std::size_t>(way); }

} // namespace placedpar::identification
