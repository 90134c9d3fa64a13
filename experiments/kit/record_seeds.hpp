#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar {

using Seeds = std::vector<std::uint64_t>;

/// As many as the studies of one link have.
inline constexpr std::size_t usual_records = 50;

/// The seeds of a study's records, each drawn from a stream of its own, which the study's seed and the record's number
/// key: more records leave the first ones as they are, and a study of another seed has other ones.
Seeds record_seeds(std::uint64_t study_seed, std::size_t records);

} // namespace placedpar
