#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace placedpar::hydraulics {

/// The valid values of a machine's constant, such as an area or a mass, in the unit that units.hpp gives for the
/// quantity.
struct ParameterRange {
    double least = -std::numeric_limits<double>::infinity();
    bool least_included = true;

    /// Returns false for NaN and infinity.
    bool contains(double value) const;
    /// Returns "above 0" or "0 or above".
    std::string expected() const;
};

/// Returns the range for a parameter, chosen by its name. An area or a mass is above 0. A noise is 0 or above. An
/// offset, a load or a voltage may have either sign. The code that uses several parameters checks the conditions
/// between them.
ParameterRange range_of(std::string_view parameter);

} // namespace placedpar::hydraulics
