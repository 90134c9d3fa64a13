#pragma once

#include "gaprocs/policies/policy.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>

namespace placedpar {

// A coding says how a string codes the parameters of a problem, each parameter in a field of bits. `dont_care` unused
// bits are inserted between every two neighbouring bits, so many strings code the same parameters. Unused bits lengthen
// the string without changing its meaning. The thesis inserts one bit (eq. 6.14 and 6.15).

/// Natural binary code, as in the thesis. The codes of neighbouring numbers may differ in every bit, as 0111 and 1000
/// do. So mutation may have to flip many bits for a small change of a parameter.
struct NaturalCoding {
    static constexpr std::string_view name = "natural", about = "fields in natural binary",
                                      source = "thesis eq. 1.5; don't-care bits: eq. 6.14 and 6.15";
    std::size_t dont_care = 0;
    static constexpr auto numbers() {
        return std::tuple(
            PolicyNumber{"dont_care", &NaturalCoding::dont_care, 0, 64,
                         "don't-care bits between every two bits of the string (thesis eq. 6.14 and 6.15)"});
    }
};

/// The binary reflected Gray code. The codes of neighbouring numbers differ in one bit.
struct GrayCoding {
    static constexpr std::string_view name = "gray",
                                      about = "fields in Gray code: the codes of successive numbers differ in one bit",
                                      source = "F. Gray, 1953; don't-care bits: thesis eq. 6.14 and 6.15";
    std::size_t dont_care = 0;
    static constexpr auto numbers() {
        return std::tuple(
            PolicyNumber{"dont_care", &GrayCoding::dont_care, 0, 64,
                         "don't-care bits between every two bits of the string (thesis eq. 6.14 and 6.15)"});
    }
};

/// The string holds the parameters themselves, as real numbers. Each number is limited to the range of its field.
struct RealCoding {
    static constexpr std::string_view name = "real",
                                      about = "the parameters themselves, as real numbers instead of bits",
                                      source = "not in the thesis";
};

class Coding : public OneOf<Coding, NaturalCoding, GrayCoding, RealCoding> {
public:
    using OneOf::OneOf;
    static constexpr std::string_view noun = "representation",
                                      about = "how a string codes the parameters of a problem, each in a field of bits";
    static const Coding natural, gray, real; ///< without don't-care bits

    /// Returns the text of the policy; `dont_care` is omitted if it is 0.
    std::string text() const { return dont_care() == 0 ? std::string(way()) : OneOf::text(); }
    /// Returns "natural", "gray" or "real".
    constexpr std::string_view way() const {
        return std::visit([](const auto& coding) { return coding.name; }, policy());
    }
    constexpr std::size_t dont_care() const {
        if (const auto* natural_coding = std::get_if<NaturalCoding>(&policy()))
            return natural_coding->dont_care;
        const auto* gray_coding = std::get_if<GrayCoding>(&policy());
        return gray_coding ? gray_coding->dont_care : 0;
    }
    /// Returns the same coding without don't-care bits.
    Coding plain() const { return named(way()); }

    friend constexpr bool operator==(const Coding& a, const Coding& b) {
        return a.way() == b.way() && a.dont_care() == b.dont_care();
    }
};

inline constexpr Coding Coding::natural{NaturalCoding{}}, Coding::gray{GrayCoding{}}, Coding::real{RealCoding{}};

} // namespace placedpar
