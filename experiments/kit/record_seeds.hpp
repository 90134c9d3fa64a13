#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar {

using Seeds = std::vector<std::uint64_t>;

/// The number of records in the studies of one link.
inline constexpr std::size_t usual_records = 50;

/// Returns the seeds of a study's records. Each is drawn from its own stream, keyed by the study's seed and the
/// record's number. More records therefore leave the first ones unchanged, and another study seed gives other records.
Seeds record_seeds(std::uint64_t study_seed, std::size_t records);

} // namespace placedpar
