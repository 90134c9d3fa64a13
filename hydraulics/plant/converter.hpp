#pragma once

#include "hydraulics/data/parameters.hpp"

#include <string_view>

namespace placedpar::hydraulics {

/// An analogue-to-digital or digital-to-analogue converter of a simulated machine. It rounds readings and voltages to
/// its resolution.
struct Converter {
    double range;
    int bits; ///< 0: values pass unchanged

    /// Returns the difference between two neighbouring codes; 0 if `bits` is 0.
    double step() const;
    /// Returns the value of the nearest code; a value half-way between two codes goes to the even code. The error is at
    /// most half a step.
    double operator()(double value) const;
    /// Returns the value of the nearest code, limited to [least, least + range - step].
    double limited(double value, double least) const;
};

/// Returns the number of bits that the parameter `name` states. Throws UnfitScenario (requirement.hpp) unless the value
/// is a whole number from 0 to 32.
int bits_of(const Parameters& parameters, std::string_view name);

} // namespace placedpar::hydraulics
