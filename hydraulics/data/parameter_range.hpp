#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace placedpar::hydraulics {

/// The values, in this room's unit, that a constant of a machine can have.
struct ParameterRange {
    double least = -std::numeric_limits<double>::infinity();
    bool least_included = true;

    /// Not of nan and infinity.
    bool contains(double value) const;
    /// "above 0", "0 or above".
    std::string expected() const;
};

/// By the parameter's name: an area or a mass is above 0, a noise 0 or above; an offset, a load or a voltage may have
/// either sign. All readers of parameters ask here; what depends on several of them is checked where they are used.
ParameterRange range_of(std::string_view parameter);

} // namespace placedpar::hydraulics
