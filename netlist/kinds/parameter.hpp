#pragma once

#include "netlist/network/value.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

enum class ParameterType { integer, real, text };

/// A value that a netlist gives to a process or to a device; description.hpp makes them.
struct ParameterDescription {
    std::string name;
    ParameterType type;
    std::string unit;                   ///< "" where it has none
    std::optional<Value> default_value; ///< of the type stated; none: the netlist must give it
    std::optional<double> least, most;  ///< range, both ends allowed
    std::vector<std::string> choices;   ///< for text: the allowed words; empty: any text
    std::string about;                  ///< one line
    /// For text that is more than a word: throws UserError, saying what would be right. `choices` are then examples.
    std::function<void(const std::string&)> check = {};
    /// Of cycles: they are of real numbers, and the default is what a processor with a unit for those takes.
    bool computes_reals = false;
    std::string noun = ""; ///< what it decides, by a name under which the program tells more; "" where it does not
};

/// "it goes from 2 to 100 bytes", "it is at least 2 bytes", "it is at most 100 bytes". REQUIRES: it has a range.
std::string range_of(const ParameterDescription& parameter);
/// Whether the number lies in the range, if there is one.
bool in_range(const ParameterDescription& parameter, double number);

} // namespace placedpar
