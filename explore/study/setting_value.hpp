#pragma once

#include "netlist/elaborate/constant.hpp"

#include <optional>
#include <string>

namespace placedpar {

/// What the text of --set is without a netlist, whose names mean nothing here. None where that is no expression: then
/// it is a text without quotes.
std::optional<Constant> constant_of_setting(const std::string& text);

/// The number that a value of --set is, as it means a clock or the speed of a link: 5M is 5 million. None for a text.
std::optional<double> number_of_setting(const std::string& text);

/// Whether it is called as a clock or the speed of a link is: "t.clock".
bool is_frequency(const std::string& name);

/// A value of --set, which is equal to others that mean the same: 8 to 8.0, a text without quotes to the same with
/// them, and, of a clock or the speed of a link, 20M to 20000000. Of anything else 20M may be a size, 20971520.
class SettingValue {
public:
    /// `name` as --set takes it: "t.clock".
    SettingValue(const std::string& name, std::string spelling);

    const std::string& spelling() const { return spelling_; }
    /// The same for equal values, and only for them.
    const std::string& meaning() const { return meaning_; }
    std::optional<double> number() const { return number_of_setting(spelling_); }
    /// With a point, or a power of ten: not everything that takes 8 takes 8.0.
    bool is_real() const { return is_real_; }

    bool operator==(const SettingValue& other) const { return meaning_ == other.meaning_; }

private:
    std::string spelling_, meaning_;
    bool is_real_;
};

/// The one by which both are called: the first, unless only the other is taken everywhere. REQUIRES: they are equal.
const SettingValue& better_spelt(const SettingValue& first, const SettingValue& other);

} // namespace placedpar
