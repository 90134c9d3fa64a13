#include "experiments/kit/record_seeds.hpp"

#include "runtime/random.hpp"

#include <fmt/format.h>

namespace placedpar {

Seeds record_seeds(std::uint64_t study_seed, std::size_t records) {
    Seeds seeds;
    for (std::size_t i = 0; i < records; ++i) {
        RandomStream stream(study_seed, fmt::format("record {}", i));
        std::uint64_t high = stream();
        seeds.push_back(high << 32 | stream());
    }
    return seeds;
}

} // namespace placedpar
