#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace placedpar {

/// How a field of bits stands for a whole number. The thesis codes in natural binary, where neighbours may differ in
/// every bit: a search that stands at 0111 cannot step to 1000. In the (binary reflected) Gray code neighbours differ
/// in one bit.
enum class Coding : unsigned char { natural, gray };

/// "natural", "gray".
constexpr std::string_view name_of(Coding coding) { return coding == Coding::gray ? "gray" : "natural"; }
std::optional<Coding> coding_named(std::string_view);

/// The Gray code of a number, and the number of a Gray code.
constexpr std::uint64_t gray_code(std::uint64_t number) { return number ^ (number >> 1); }
constexpr std::uint64_t gray_decoded(std::uint64_t code) {
    for (unsigned shift = 1; shift < 64; shift *= 2)
        code ^= code >> shift;
    return code;
}

/// A binary string whose fields are in Gray code, each field by itself. A problem that reads its string by
/// field(first, count) can read this one instead, unchanged.
template <typename G>
class GrayCoded {
public:
    /// REQUIRES: the string outlives this.
    explicit GrayCoded(const G& genome) : genome_(genome) {}

    std::size_t size() const { return genome_.size(); }
    std::uint64_t field(std::size_t first, std::size_t count) const {
        return gray_decoded(genome_.field(first, count));
    }

private:
    const G& genome_;
};

} // namespace placedpar
