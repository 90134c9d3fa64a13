#include "gaprocs/genome.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace placedpar {

Genome Genome::from_string(std::string_view text) {
    Genome genome(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '0' && text[i] != '1')
            throw std::invalid_argument(
                fmt::format("a binary string holds 0 and 1 only: '{}' has '{}' at position {}", text, text[i], i));
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

void Genome::set(std::size_t position, bool value) {
    if (bit(position) != value)
        flip(position);
}

void Genome::set_field(std::size_t first, std::size_t count, std::uint64_t value) {
    for (std::size_t i = 0; i < count; ++i)
        set(first + i, (value >> (count - 1 - i)) & 1u);
}

void swap_leading(Genome& a, Genome& b, std::size_t count) {
    std::size_t whole = count / 64;
    for (std::size_t word = 0; word < whole; ++word)
        std::swap(a.words_[word], b.words_[word]);
    if (count % 64 == 0)
        return;
    std::uint64_t leading = ~(~std::uint64_t{0} >> (count % 64));
    std::uint64_t difference = (a.words_[whole] ^ b.words_[whole]) & leading;
    a.words_[whole] ^= difference;
    b.words_[whole] ^= difference;
}

std::string Genome::to_string() const {
    std::string text(size_, '0');
    for (std::size_t i = 0; i < size_; ++i)
        if (bit(i))
            text[i] = '1';
    return text;
}

} // namespace placedpar
