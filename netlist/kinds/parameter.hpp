#pragma once

#include "netlist/network/value.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

enum class ParameterType { integer, real, text };

/// Describes a parameter of a process or an attribute of a device, to which a netlist gives a value. Functions of
/// description.hpp make descriptions.
struct ParameterDescription {
    std::string name;
    ParameterType type;
    std::string unit;                   ///< "" if there is no unit
    std::optional<Value> default_value; ///< value of the stated type; empty: the netlist must give a value
    std::optional<double> least, most;  ///< range, both ends allowed
    std::vector<std::string> choices;   ///< for text: the allowed words; empty: any text
    std::string about;                  ///< one line
    /// Checks a text that has its own syntax. Throws UserError, which says what would be right. If this function is not
    /// empty, `choices` are only examples.
    std::function<void(const std::string&)> check = {};
    /// True if the parameter counts processor cycles of real-number arithmetic. Its default value then assumes a
    /// processor with a floating-point unit.
    bool computes_reals = false;
    std::string noun = ""; ///< topic of the help text that lists the values; "": no help text lists them
};

/// Returns "from 2 to 100 bytes", "at least 2 bytes" or "at most 100 bytes". REQUIRES: the parameter has a range.
std::string range_of(const ParameterDescription& parameter);
/// Returns whether the number lies in the range; true if there is no range.
bool in_range(const ParameterDescription& parameter, double number);

} // namespace placedpar
