#include "runtime/random.hpp"

#include "runtime/vector_width.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace placedpar {

namespace {

/// FNV-1a, 64 bits: a published, stable hash, for std::hash may differ from one library to the next.
std::uint64_t path_hash(std::string_view path) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (char c : path)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

void count_on(r123::Philox4x32::ctr_type& counter, std::uint32_t blocks) {
    counter[0] += blocks;
    counter[1] += counter[0] < blocks; // carried
}

#ifdef __x86_64__
/// Philox 4x32-10 of the blocks that follow one another, as many at once as a register has places of 64 bits. A word of
/// 32 bits has such a place for itself; what stands in the upper half is carried along and never used.
template <std::size_t width>
class Blocks {
public:
    [[gnu::always_inline]] Blocks(const r123::Philox4x32::ctr_type& counter, std::size_t first) {
        std::uint64_t number = counter[0] + (std::uint64_t{counter[1]} << 32) + first;
        std::array<std::array<std::uint64_t, width>, 4> words;
        for (std::size_t i = 0; i < width; ++i)
            words[0][i] = number + i;
        for (std::size_t i = 0; i < width; ++i)
            words[1][i] = words[0][i] >> 32;
        words[2].fill(counter[2]);
        words[3].fill(counter[3]);
        std::memcpy(words_, words.data(), sizeof words_);
    }

    [[gnu::always_inline]] void mix(r123::Philox4x32::key_type key) {
        for (int round = 0; round < 10; ++round) {
            Register first, third;
            multiply(words_[0], PHILOX_M4x32_0, first);
            multiply(words_[2], PHILOX_M4x32_1, third);
            words_[0] = (third >> 32) ^ words_[1] ^ key[0];
            words_[1] = third;
            words_[2] = (first >> 32) ^ words_[3] ^ key[1];
            words_[3] = first;
            key[0] += PHILOX_W32_0;
            key[1] += PHILOX_W32_1;
        }
    }

    /// Block after block, of each its four words.
    [[gnu::always_inline]] void store(std::uint32_t* numbers) const {
        constexpr std::uint64_t lower = 0xffffffff;
        Register pairs[2] = {(words_[0] & lower) | (words_[1] << 32), (words_[2] & lower) | (words_[3] << 32)};
        std::array<std::array<std::uint64_t, width>, 2> halves;
        std::memcpy(halves.data(), pairs, sizeof pairs);
        for (std::size_t i = 0; i < width; ++i) {
            std::memcpy(numbers + 4 * i, &halves[0][i], sizeof(std::uint64_t));
            std::memcpy(numbers + 4 * i + 2, &halves[1][i], sizeof(std::uint64_t));
        }
    }

private:
    using Register = typename Registers<width>::Words;

    [[PLACEDPAR_AVX2]] static void multiply(const Register& a, std::uint32_t b,
                                            Register& product) requires(width == 4) {
        product = reinterpret_cast<Register>(_mm256_mul_epu32(reinterpret_cast<__m256i>(a), _mm256_set1_epi64x(b)));
    }
    // The form with a mask, since GCC 12 warns of the other, its bug 105593.
    [[PLACEDPAR_AVX512]] static void multiply(const Register& a, std::uint32_t b,
                                              Register& product) requires(width == 8) {
        product = reinterpret_cast<Register>(
            _mm512_maskz_mul_epu32(0xff, reinterpret_cast<__m512i>(a), _mm512_set1_epi64(b)));
    }

    alignas(sizeof(std::uint64_t) * width) Register words_[4];
};
#endif

/// `blocks` times the four numbers of a counter, which counts on.
template <std::size_t width>
void compute(r123::Philox4x32::ctr_type counter, r123::Philox4x32::key_type key, std::size_t blocks,
             std::uint32_t* numbers) {
#ifdef __x86_64__
    if constexpr (width > 2) {
        for (std::size_t first = 0; first < blocks; first += width) {
            Blocks<width> several(counter, first);
            several.mix(key);
            several.store(numbers + 4 * first);
        }
        return;
    }
#endif
    for (std::size_t i = 0; i < blocks; ++i) {
        auto block = r123::Philox4x32{}(counter, key);
        std::copy(block.begin(), block.end(), numbers + 4 * i);
        count_on(counter, 1);
    }
}

} // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view path)
    : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}}, numbers_{} {
    // The upper half of the counter names the stream, the lower half counts its blocks.
    std::uint64_t stream = path_hash(path);
    counter_ = {{0, 0, static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(stream >> 32)}};
}

void RandomStream::compute_ahead() {
    in_vectors([&]<std::size_t width>() { compute<width>(counter_, key_, ahead / 4, numbers_.data()); });
    count_on(counter_, ahead / 4);
    drawn_ = 0;
}

void RandomStream::fill(std::span<result_type> numbers) {
    while (!numbers.empty()) {
        if (drawn_ == ahead)
            compute_ahead();
        std::size_t count = std::min(numbers.size(), ahead - drawn_);
        std::copy_n(numbers_.data() + drawn_, count, numbers.data());
        drawn_ += count;
        numbers = numbers.subspan(count);
    }
}

void RandomStream::reject(std::uint64_t& product, std::uint32_t n) {
    std::uint32_t threshold = (0u - n) % n;
    while (static_cast<std::uint32_t>(product) < threshold)
        product = std::uint64_t{(*this)()} * n;
}

double RandomStream::normal() {
    double radius = std::sqrt(-2 * std::log(1 - uniform()));
    return radius * std::cos(2 * std::numbers::pi * uniform());
}

} // namespace placedpar
