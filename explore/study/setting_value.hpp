#pragma once

#include "netlist/elaborate/constant.hpp"

#include <optional>
#include <string>

namespace placedpar {

/// Evaluates a value of the option --set without a netlist. Returns nothing if the value is not an expression or
/// contains a name. Such a value is a text without quotes.
std::optional<Constant> constant_of_setting(const std::string& text);

/// Returns the number that a value of --set means for a clock or the speed of a link: 5M is 5 million. Returns nothing
/// if the value is not a number.
std::optional<double> number_of_setting(const std::string& text);

/// Returns whether the setting of this name is a clock or the speed of a link: "t.clock".
bool is_frequency(const std::string& name);

/// A value of --set, compared by its meaning: 8 equals 8.0, and a text equals the same text in quotes. For a clock or
/// the speed of a link, 20M equals 20000000. For other settings 20M differs from 20000000, because 20M may be a size of
/// 20971520 bytes.
class SettingValue {
public:
    /// `name` as --set takes it: "t.clock".
    SettingValue(const std::string& name, std::string spelling);

    const std::string& spelling() const { return spelling_; }
    /// Returns a text that is equal for equal values, and different for different values.
    const std::string& meaning() const { return meaning_; }
    std::optional<double> number() const { return number_of_setting(spelling_); }
    /// Returns whether the number is written with a point or a power of ten. Some settings accept 8, but not 8.0.
    bool is_real() const { return is_real_; }

    bool operator==(const SettingValue& other) const { return meaning_ == other.meaning_; }

private:
    std::string spelling_, meaning_;
    bool is_real_;
};

/// Returns the spelling to use for both values: the first, unless some setting accepts only the other spelling.
/// REQUIRES: the values are equal.
const SettingValue& better_spelt(const SettingValue& first, const SettingValue& other);

} // namespace placedpar
