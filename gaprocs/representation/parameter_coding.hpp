#pragma once

#include "gaprocs/representation/representation.hpp"
#include "gaprocs/representation/strings_in_lanes.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace placedpar {

/// A binary string whose fields of bits can be read as whole numbers.
template <typename G>
concept BinaryString = requires(const G& genome) {
    { genome.field(std::size_t{}, std::size_t{}) } -> std::convertible_to<std::uint64_t>;
};

/// A parameter of a problem, coded in a field of bits of a string. The whole number n in the field stands for `low` +
/// (`high` - `low`) * n / 2^`bits` (thesis eq. 1.5). So no code stands for `high`. If the parameter is `whole`, its
/// value is rounded down: with `low` = 1 and `high` = 5 it is 1, 2, 3 or 4.
struct ParameterField {
    double low = 0, high = 1; ///< in the parameter's unit
    std::size_t bits = 10;
    bool whole = false;

    /// Returns the number of codes, 2^bits.
    double codes() const { return static_cast<double>(std::uint64_t{1} << bits); }
    /// REQUIRES: code < 2^bits.
    double value(std::uint64_t code) const {
        double value = low + resolution() * static_cast<double>(code);
        return whole ? std::floor(value) : value;
    }
    /// Returns the number, rounded down if the parameter is `whole`, to a value that a code can have. REQUIRES: low <=
    /// number <= high.
    double rounded(double number) const { return whole ? std::min(std::floor(number), std::ceil(high) - 1) : number; }
    /// Returns the difference between the values of neighbouring codes, before rounding.
    double resolution() const { return (high - low) / codes(); }
};

/// The coding of all parameters in one binary string, as consecutive fields (thesis eq. 1.6).
class ParameterCoding {
public:
    /// The largest number of bits in a field; a double can represent every whole number with this number of bits.
    static constexpr std::size_t most_bits = 52;

    /// Throws std::invalid_argument if there are no fields, or if the `bits` of a field are outside 1 ... `most_bits`.
    /// Throws it also unless each range has finite ends, `low` < `high` and a finite width.
    explicit ParameterCoding(std::vector<ParameterField> fields);
    /// Codes each of `parameters` parameters in a field like `each`.
    ParameterCoding(std::size_t parameters, const ParameterField& each)
        : ParameterCoding(std::vector<ParameterField>(parameters, each)) {}

    std::size_t parameters() const { return fields_.size(); }
    const ParameterField& field(std::size_t parameter) const { return fields_[parameter]; }
    /// Returns the number of bits of each field.
    std::vector<std::size_t> fields() const;
    /// Returns the length of the whole string in bits.
    std::size_t bits() const { return bits_; }
    /// Returns the representation of the parameters as real numbers in the ranges of their fields. The caller has to
    /// round `whole` parameters by ParameterField::rounded().
    RealVector reals() const;

    /// Returns the value of a parameter in a string. REQUIRES: parameter < parameters(), and a string of bits() bits.
    template <BinaryString G>
    double value(const G& genome, std::size_t parameter) const {
        const Field& place = places_[parameter];
        auto code = static_cast<std::int64_t>(genome.field(place.first, place.bits)); // signed, because its conversion
                                                                                      // to double is faster
        double value = place.low + place.resolution * static_cast<double>(code);
        return place.whole ? std::floor(value) : value;
    }
    /// Returns the values of a parameter in several strings, which lie side by side in vector registers.
    template <std::size_t width, bool gray>
    [[gnu::always_inline]] Lanes<width> value(const StringsInLanes<width, gray>& strings, std::size_t parameter) const {
        const Field& place = places_[parameter];
        Lanes<width> value = place.low + place.resolution * strings.field(place.first, place.bits);
        return place.whole ? floor(value) : value;
    }
    template <BinaryString G>
    std::vector<double> decode(const G& genome) const {
        std::vector<double> values(parameters());
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = value(genome, i);
        return values;
    }

private:
    /// The data of a field, in the form that value() uses. `first` is the position of the field's first bit in the
    /// string.
    struct Field {
        std::size_t first, bits;
        double low, resolution;
        bool whole;
    };

    std::vector<ParameterField> fields_;
    std::vector<Field> places_;
    std::size_t bits_ = 0;
};

} // namespace placedpar
