#pragma once

#include "gaprocs/representation/genome.hpp"
#include "runtime/lanes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace placedpar {

/// Binary strings of several individuals, side by side in vector registers: each string has one lane. field() reads a
/// field (the bits of one parameter) of all these strings at once, several times as fast as a loop over the strings.
/// The rules at the top of runtime/lanes.hpp apply.
template <std::size_t width, bool gray = false>
class StringsInLanes {
public:
    static constexpr std::size_t count = Lanes<width>::count;
    /// The largest number of 64-bit words in a string. Callers have to read longer strings one by one, without this
    /// class.
    static constexpr std::size_t most_words = 4;

    /// Takes the strings from index `first` on. If fewer strings than lanes are left, the other lanes repeat the last
    /// string. REQUIRES: first < population.size(); all strings have the same size, at most `most_words` words.
    [[gnu::always_inline]] StringsInLanes(std::span<const Genome> population, std::size_t first) {
        const std::size_t used = population[first].words().size();
        for (std::size_t word = 0; word < used; ++word) {
            std::uint64_t words[count];
            for (std::size_t lane = 0; lane < count; ++lane)
                words[lane] = population[std::min(first + lane, population.size() - 1)].words()[word];
            std::memcpy(words_[word], words, sizeof words);
        }
    }

    /// Reads a field as Genome::field() does. REQUIRES: what Genome::field() requires, and bits <= 52, because the
    /// field's number must fit a double exactly.
    [[gnu::always_inline]] Lanes<width> field(std::size_t first, std::size_t bits) const {
        const std::size_t word = first / 64, offset = first % 64;
        alignas(alignment) Codes codes[registers];
        for (std::size_t i = 0; i < registers; ++i) {
            codes[i] = words_[word][i] << offset;
            if (offset + bits > 64)
                codes[i] |= words_[word + 1][i] >> (64 - offset);
            codes[i] >>= 64 - bits;
            if constexpr (gray)
                for (std::size_t shift = 1; shift < bits; shift *= 2)
                    codes[i] ^= codes[i] >> shift;
        }
        return Lanes<width>::of_whole_numbers(codes);
    }

private:
    using Codes = typename Registers<width>::Words;
    static constexpr std::size_t registers = count / width;
    static constexpr std::size_t alignment = sizeof(std::uint64_t) * width; // the alignment of Lanes

    alignas(alignment) Codes words_[most_words][registers];
};

} // namespace placedpar
