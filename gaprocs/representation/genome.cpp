#include "gaprocs/representation/genome.hpp"

#include "runtime/random.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

namespace placedpar {

Genome Genome::from_string(std::string_view text) {
    Genome genome(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '0' && text[i] != '1')
            throw std::invalid_argument(fmt::format(
                "a binary string has only the characters 0 and 1: '{}' has '{}' at position {}", text, text[i], i));
        genome.set(i, text[i] == '1');
    }
    return genome;
}

Genome Genome::random(std::size_t size, RandomStream& random) {
    Genome genome(size);
    for (std::size_t first = 0; first < size; first += 32) {
        std::uint64_t half = random();
        genome.words_[first / 64] |= half << (first % 64 == 0 ? 32 : 0);
    }
    if (size % 64 != 0)
        genome.words_.back() &= ~std::uint64_t{0} << (64 - size % 64);
    return genome;
}

void Genome::assign_words(const Genome& other) {
    if (words_.size() == other.words_.size())
        std::ranges::copy(other.words_, words_.begin());
    else
        words_ = other.words_;
}

void Genome::set(std::size_t position, bool value) {
    if (bit(position) != value)
        flip(position);
}

void Genome::set_field(std::size_t first, std::size_t count, std::uint64_t value) {
    for (std::size_t i = 0; i < count; ++i)
        set(first + i, (value >> (count - 1 - i)) & 1u);
}

void swap_where(Genome& a, Genome& b, const Genome& mask) {
    for (std::size_t word = 0; word < mask.words_.size(); ++word) {
        std::uint64_t exchanged = (a.words_[word] ^ b.words_[word]) & mask.words_[word];
        a.words_[word] ^= exchanged;
        b.words_[word] ^= exchanged;
    }
}

std::size_t difference(const Genome& a, const Genome& b) {
    std::size_t bits = 0;
    for (std::size_t word = 0; word < a.words_.size(); ++word)
        bits += static_cast<std::size_t>(std::popcount(a.words_[word] ^ b.words_[word]));
    return bits;
}

std::size_t first_difference(const Genome& a, const Genome& b) {
    for (std::size_t word = 0; word < a.words_.size(); ++word)
        if (std::uint64_t differ = a.words_[word] ^ b.words_[word])
            return 64 * word + static_cast<std::size_t>(std::countl_zero(differ));
    return a.size();
}

std::size_t last_difference(const Genome& a, const Genome& b) {
    for (std::size_t word = a.words_.size(); word-- > 0;)
        if (std::uint64_t differ = a.words_[word] ^ b.words_[word])
            return 64 * word + 63 - static_cast<std::size_t>(std::countr_zero(differ));
    return a.size();
}

std::string Genome::to_string() const {
    std::string text(size_, '0');
    for (std::size_t i = 0; i < size_; ++i)
        if (bit(i))
            text[i] = '1';
    return text;
}

std::vector<Genome> random_population(std::size_t count, std::size_t bits, RandomStream& random) {
    std::vector<Genome> population;
    population.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
        population.push_back(Genome::random(bits, random));
    return population;
}

} // namespace placedpar
