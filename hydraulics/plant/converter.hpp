#pragma once

#include "hydraulics/data/parameters.hpp"

#include <string_view>

namespace placedpar::hydraulics {

/// An analogue-digital converter, or the other way round.
struct Converter {
    double range;
    int bits; ///< 0: it passes values as they are

    /// The least difference it can tell; 0 without bits.
    double step() const;
    /// The nearest code's value, half to even; the error is at most half a step.
    double operator()(double value) const;
    /// The same, kept within [least, least + range - step].
    double limited(double value, double least) const;
};

/// The bits that a row of the parameters gives. Throws UnfitScenario (requirement.hpp) unless it is a whole number from
/// 0 to 32.
int bits_of(const Parameters& parameters, std::string_view name);

} // namespace placedpar::hydraulics
