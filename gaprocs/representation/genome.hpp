#pragma once

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace placedpar {

class RandomStream; // runtime/random.hpp

/// A binary string of any length, which codes one individual of a genetic algorithm (thesis 1.1, eq. 1.6).
///
/// Bit 0 is the leftmost character of the text, and the most significant bit of words()[0]. So shifts suffice to read a
/// field of bits as a natural binary number:
///
///     bit        0 1 2 ... 63    64 65 ...
///     words()   [0]              [1]            bits past size() are always zero
class Genome {
public:
    Genome() = default;
    /// Makes a string of `size` zeros.
    explicit Genome(std::size_t size) : words_((size + 63) / 64, 0), size_(size) {}
    Genome(const Genome&) = default;
    Genome(Genome&&) = default;
    Genome& operator=(Genome&&) = default;
    /// Copies without allocating memory if the length stays the same.
    Genome& operator=(const Genome& other) {
        if (words_.size() == 1 && other.words_.size() == 1) // most strings
            words_.front() = other.words_.front();
        else
            assign_words(other);
        size_ = other.size_;
        return *this;
    }

    /// Reads a string of characters '0' and '1'. Throws std::invalid_argument for other characters.
    static Genome from_string(std::string_view text);
    /// Returns a random string; each bit is 1 with probability 1/2. Draws ceil(size / 32) random numbers.
    static Genome random(std::size_t size, RandomStream& random);

    std::size_t size() const { return size_; }
    /// Returns the number of bytes that the string takes in a message.
    std::size_t bytes() const { return (size_ + 7) / 8; }
    std::span<const std::uint64_t> words() const { return {words_.data(), words_.size()}; }

    /// REQUIRES of the next three functions: position < size().
    bool bit(std::size_t position) const { return (words_[position / 64] & mask(position)) != 0; }
    void set(std::size_t position, bool value);
    void flip(std::size_t position) { words_[position / 64] ^= mask(position); }

    /// Returns the natural binary number in the `count` bits from `first` on; the leftmost bit is the most significant.
    /// REQUIRES: 1 <= count <= 64, first + count <= size().
    std::uint64_t field(std::size_t first, std::size_t count) const;
    /// Stores a number as field() reads it. REQUIRES: what field() requires, and value < 2^count.
    void set_field(std::size_t first, std::size_t count, std::uint64_t value);

    /// Sets the bits 64 * index to 64 * index + 63. REQUIRES: 64 * (index + 1) <= size().
    void set_word(std::size_t index, std::uint64_t value) { words_[index] = value; }

    /// Exchanges the first `count` bits of two strings. REQUIRES: a.size() == b.size(), count <= a.size().
    friend void swap_leading(Genome& a, Genome& b, std::size_t count);
    /// Exchanges the bits at which `mask` has a 1. REQUIRES: all three strings have the same size.
    friend void swap_where(Genome& a, Genome& b, const Genome& mask);

    // REQUIRES of the next three functions: both strings have the same size.
    /// Returns the number of bits in which the strings differ.
    friend std::size_t difference(const Genome& a, const Genome& b);
    /// Return the position of the first (last) bit in which the strings differ; size() if they are equal.
    friend std::size_t first_difference(const Genome& a, const Genome& b);
    friend std::size_t last_difference(const Genome& a, const Genome& b);

    std::string to_string() const;
    friend bool operator==(const Genome&, const Genome&) = default;

private:
    void assign_words(const Genome& other);
    static std::uint64_t mask(std::size_t position) { return 0x8000000000000000u >> (position % 64); }

    // Strings of up to 64 bits are stored in the object itself.
    boost::container::small_vector<std::uint64_t, 1> words_;
    std::size_t size_ = 0;
};

/// Returns `count` random strings of `bits` bits.
std::vector<Genome> random_population(std::size_t count, std::size_t bits, RandomStream& random);

inline void swap_leading(Genome& a, Genome& b, std::size_t count) {
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

inline std::uint64_t Genome::field(std::size_t first, std::size_t count) const {
    std::size_t word = first / 64, offset = first % 64;
    std::uint64_t bits = words_[word] << offset;
    if (offset + count > 64)
        bits |= words_[word + 1] >> (64 - offset);
    return bits >> (64 - count);
}

} // namespace placedpar
