#pragma once

#include <array>
#include <cstddef>

namespace placedpar::identification {

/// The ways in which a link can deviate from a healthy link. Each way causes a missing flow, that is, an error of the
/// flow balance. These flows distinguish the ways:
///
/// - a wrong compliance: in proportion to the slope of the pressure;
/// - a leak: in proportion to the pressure, even at rest after the valve has shut;
/// - an offset of the spool, or a drift between voltage and spool: only while oil flows through the valve;
/// - a leak before the movement. Its size may differ from the leak during the movement, since a leak can begin when the
///   valve opens.
enum class FaultHypothesis : unsigned char { compliance, leak, offset, leak_before };

inline constexpr std::array<FaultHypothesis, 4> all_hypotheses{FaultHypothesis::compliance, FaultHypothesis::leak,
                                                               FaultHypothesis::offset, FaultHypothesis::leak_before};

/// One number per hypothesis, in the order of all_hypotheses. PerPairOfHypotheses is a square matrix, column by column.
/// way_matrices.hpp has functions that compute with these types.
using PerHypothesis = std::array<double, all_hypotheses.size()>;
using PerPairOfHypotheses = std::array<double, all_hypotheses.size() * all_hypotheses.size()>;

inline constexpr std::size_t index_of(FaultHypothesis way) { return static_cast<std::size_t>(way); }

} // namespace placedpar::identification
