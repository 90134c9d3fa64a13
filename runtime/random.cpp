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

/// Returns the FNV-1a hash of 64 bits. std::hash will not do, because it differs between libraries.
std::uint64_t path_hash(std::string_view path) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (char c : path)
        hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
    return hash;
}

void count_on(r123::Philox4x32::ctr_type& counter, std::uint32_t blocks) {
    counter[0] += blocks;
    counter[1] += counter[0] < blocks; // carry
}

#ifdef __x86_64__
/// Computes Philox 4x32-10 for 2 * width consecutive blocks of four numbers. A register has `width` lanes of 64 bits.
/// Each lane holds one word of 32 bits of one block in its lower half. The same word of all blocks takes two registers.
/// So the processor can work on one register while it waits for the product of the other.
template <std::size_t width>
class Blocks {
public:
    static constexpr std::size_t count = 2 * width;

    [[gnu::always_inline]] Blocks(const r123::Philox4x32::ctr_type& counter, std::size_t first) {
        std::uint64_t number = counter[0] + (std::uint64_t{counter[1]} << 32) + first;
        std::array<std::array<std::uint64_t, count>, 4> words;
        for (std::size_t i = 0; i < count; ++i)
            words[0][i] = number + i;
        for (std::size_t i = 0; i < count; ++i)
            words[1][i] = words[0][i] >> 32;
        words[2].fill(counter[2]);
        words[3].fill(counter[3]);
        std::memcpy(words_, words.data(), sizeof words_);
    }

    [[gnu::always_inline]] void mix(r123::Philox4x32::key_type key) {
        for (int round = 0; round < 10; ++round) {
            mix_one(key, 0);
            mix_one(key, 1);
            key[0] += PHILOX_W32_0;
            key[1] += PHILOX_W32_1;
        }
    }

    /// Stores the blocks in order, four words for each block.
    [[gnu::always_inline]] void store(std::uint32_t* numbers) const {
        store_one(0, numbers);
        store_one(1, numbers + 4 * width);
    }

private:
    using Register = typename Registers<width>::Words;

    [[gnu::always_inline]] void mix_one(const r123::Philox4x32::key_type& key, std::size_t half) {
        Register first, third;
        multiply(words_[0][half], PHILOX_M4x32_0, first);
        multiply(words_[2][half], PHILOX_M4x32_1, third);
        words_[0][half] = (third >> 32) ^ words_[1][half] ^ key[0];
        words_[1][half] = third;
        words_[2][half] = (first >> 32) ^ words_[3][half] ^ key[1];
        words_[3][half] = first;
    }

    [[gnu::always_inline]] void store_one(std::size_t half, std::uint32_t* numbers) const {
        constexpr std::uint64_t lower = 0xffffffff;
        Register pairs[2] = {(words_[0][half] & lower) | (words_[1][half] << 32),
                             (words_[2][half] & lower) | (words_[3][half] << 32)};
        std::array<std::array<std::uint64_t, width>, 2> halves;
        std::memcpy(halves.data(), pairs, sizeof pairs);
        for (std::size_t i = 0; i < width; ++i) {
            std::memcpy(numbers + 4 * i, &halves[0][i], sizeof(std::uint64_t));
            std::memcpy(numbers + 4 * i + 2, &halves[1][i], sizeof(std::uint64_t));
        }
    }

    static void multiply(const Register& a, std::uint32_t b, Register& product) requires(width == 2) {
        product = reinterpret_cast<Register>(_mm_mul_epu32(reinterpret_cast<__m128i>(a), _mm_set1_epi64x(b)));
    }
    [[PLACEDPAR_AVX2]] static void multiply(const Register& a, std::uint32_t b,
                                            Register& product) requires(width == 4) {
        product = reinterpret_cast<Register>(_mm256_mul_epu32(reinterpret_cast<__m256i>(a), _mm256_set1_epi64x(b)));
    }
    // The intrinsic with a mask is used, because GCC 12 gives a wrong warning for the intrinsic without a mask (bug
    // 105593).
    [[PLACEDPAR_AVX512]] static void multiply(const Register& a, std::uint32_t b,
                                              Register& product) requires(width == 8) {
        product = reinterpret_cast<Register>(
            _mm512_maskz_mul_epu32(0xff, reinterpret_cast<__m512i>(a), _mm512_set1_epi64(b)));
    }

    alignas(sizeof(std::uint64_t) * width) Register words_[4][2];
};
#endif

/// Computes the four numbers of each of `blocks` consecutive counters.
template <std::size_t width>
void compute(r123::Philox4x32::ctr_type counter, r123::Philox4x32::key_type key, std::size_t blocks,
             std::uint32_t* numbers) {
#ifdef __x86_64__
    for (std::size_t first = 0; first < blocks; first += Blocks<width>::count) {
        Blocks<width> several(counter, first);
        several.mix(key);
        several.store(numbers + 4 * first);
    }
#else
    for (std::size_t i = 0; i < blocks; ++i) {
        auto block = r123::Philox4x32{}(counter, key);
        std::copy(block.begin(), block.end(), numbers + 4 * i);
        count_on(counter, 1);
    }
#endif
}

/// Computes blocks and advances the counter. REQUIRES: `blocks` is a multiple of 16, so that it fills registers of any
/// width.
void compute_blocks(r123::Philox4x32::ctr_type& counter, const r123::Philox4x32::key_type& key, std::size_t blocks,
                    std::uint32_t* numbers) {
    in_vectors([&]<std::size_t width>() { compute<width>(counter, key, blocks, numbers); });
    count_on(counter, static_cast<std::uint32_t>(blocks));
}

} // namespace

RandomStream::RandomStream(std::uint64_t seed, std::string_view path)
    : key_{{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)}}, numbers_{} {
    // The upper half of the counter identifies the stream; the lower half counts the blocks of the stream.
    std::uint64_t stream = path_hash(path);
    counter_ = {{0, 0, static_cast<std::uint32_t>(stream), static_cast<std::uint32_t>(stream >> 32)}};
}

void RandomStream::compute_ahead() {
    compute_blocks(counter_, key_, ahead / 4, numbers_.data());
    drawn_ = 0;
}

void RandomStream::fill(std::span<result_type> numbers) {
    auto take = [&] {
        const std::size_t count = std::min(numbers.size(), ahead - drawn_);
        std::copy_n(numbers_.data() + drawn_, count, numbers.data());
        drawn_ += count;
        numbers = numbers.subspan(count);
    };
    take();
    // As many numbers as possible, in multiples of `ahead`, are computed directly into `numbers`. This saves a copy.
    if (const std::size_t straight = numbers.size() / ahead * ahead; straight > 0) {
        compute_blocks(counter_, key_, straight / 4, numbers.data());
        numbers = numbers.subspan(straight);
    }
    if (!numbers.empty()) {
        compute_ahead();
        take();
    }
}

std::uint64_t RandomStream::drawn() const {
    const std::uint64_t blocks = std::uint64_t{counter_[1]} << 32 | counter_[0];
    return 4 * blocks - (ahead - drawn_);
}

void RandomStream::go_to(std::uint64_t drawn) {
    const std::uint64_t block = drawn / 4;
    counter_[0] = static_cast<std::uint32_t>(block);
    counter_[1] = static_cast<std::uint32_t>(block >> 32);
    compute_ahead();
    drawn_ = drawn % 4;
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
