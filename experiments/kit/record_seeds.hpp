#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar {

using Seeds = std::vector<std::uint64_t>;

/// The usual number of simulated records in a study of one link of the excavator.
inline constexpr std::size_t usual_records = 50;

/// Returns the seeds of a study's records. Each seed is drawn from its own stream, keyed by the study's seed and the
/// record's number. So the first seeds stay the same if more records are made.
Seeds record_seeds(std::uint64_t study_seed, std::size_t records);

} // namespace placedpar
