#include "gaprocs/policies/mutation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace placedpar {

void BitMutation::operator()(std::span<Genome> population, RandomStream& random) const {
    // number * 2^-32 < probability, in whole numbers: RandomStream::chance without its conversion to double.
    const auto limit = static_cast<std::uint64_t>(std::ceil(probability * 0x1p32));
    std::size_t to_draw = 0;
    for (const Genome& genome : population)
        to_draw += genome.size();
    std::array<std::uint32_t, 256> numbers;
    std::size_t drawn = 0, used = 0;
    for (Genome& genome : population)
        for (std::size_t bit = 0, bits = genome.size(); bit < bits; ++bit) {
            if (used == drawn) {
                drawn = std::min(numbers.size(), to_draw);
                to_draw -= drawn;
                used = 0;
                random.fill(std::span(numbers).first(drawn));
            }
            if (numbers[used++] < limit)
                genome.flip(bit);
        }
}

} // namespace placedpar
