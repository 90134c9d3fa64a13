#include "runtime/random.hpp"

#include <cmath>
#include <numbers>

namespace placedpar {

namespace {

/// FNV-1a, 64 bits: a published, stable hash, for std::hash may differ from one library to the next.
std::uint64_t path_hash(std::string_view path) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (char c : path)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

} // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view path)
    : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}}, block_{}, drawn_from_block_(4) {
    // The upper half of the counter names the stream, the lower half counts its blocks.
    std::uint64_t stream = path_hash(path);
    counter_ = {{0, 0, static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(stream >> 32)}};
}

void RandomStream::next_block() {
    block_ = Philox{}(counter_, key_);
    if (++counter_[0] == 0)
        ++counter_[1];
    drawn_from_block_ = 0;
}

void RandomStream::fill(std::span<result_type> numbers) {
    while (!numbers.empty() && drawn_from_block_ < 4) {
        numbers.front() = block_[drawn_from_block_++];
        numbers = numbers.subspan(1);
    }
    for (; numbers.size() >= 4; numbers = numbers.subspan(4)) {
        next_block();
        for (unsigned i = 0; i < 4; ++i)
            numbers[i] = block_[i];
        drawn_from_block_ = 4;
    }
    for (result_type& number : numbers)
        number = (*this)();
}

std::uint32_t RandomStream::below(std::uint32_t n) {
    // Lemire's multiplication with rejection (ACM TOMACS 29, 2019).
    std::uint64_t product = std::uint64_t{(*this)()} * n;
    if (auto low = static_cast<std::uint32_t>(product); low < n) {
        std::uint32_t threshold = (0u - n) % n;
        while (static_cast<std::uint32_t>(product) < threshold)
            product = std::uint64_t{(*this)()} * n;
    }
    return static_cast<std::uint32_t>(product >> 32);
}

double RandomStream::normal() {
    double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
}

} // namespace placedpar
