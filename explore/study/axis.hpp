#pragma once

#include "explore/study/setting_value.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// One part of a study's setting: a single value, or the values of a range.
class StudyValues {
public:
    /// Reads the values of the setting `name`: "5M", "0..7", "0..100..10" (steps of 10) or "1..64..x2" (each value is
    /// twice the preceding value). A range is ascending. It includes its upper end if a step reaches this end exactly.
    /// Throws UserError if the range is empty or its ends are not numbers.
    StudyValues(const std::string& name, std::string_view text);

    std::uint64_t count() const { return count_; }
    /// Returns the value as text for --set. REQUIRES: index < count().
    std::string at(std::uint64_t index) const;
    bool is_range() const { return is_range_; }
    /// Returns the value that is equal to the argument, if there is one.
    std::optional<SettingValue> find(const SettingValue&) const;

private:
    void read_range(std::string_view text, std::size_t dots);
    double steps_to(double value) const;
    void count_steps(std::string_view text, double from, double to);

    std::string name_;
    SettingValue only_; ///< the single value, if there is no range
    double from_ = 0, step_ = 1;
    bool is_range_ = false, multiplies_ = false, whole_ = true;
    std::uint64_t count_ = 1;
};

/// A setting that a study varies, with its values. A setting is a constant (`val`), attribute or parameter of the
/// netlist, named as in the option --set.
struct StudyAxis {
    std::string name;
    std::vector<StudyValues> parts;

    /// Returns the number of values. Throws UserError if this number exceeds 64 bits.
    std::uint64_t count() const;
    /// REQUIRES: index < count().
    std::string at(std::uint64_t index) const;
    /// Returns the value that is equal to the argument, if there is one.
    std::optional<SettingValue> find(const SettingValue&) const;
};

/// Reads an axis such as "slaves=0..7,10". Commas separate its parts, except within quotes, parentheses or braces.
/// Throws UserError.
StudyAxis read_axis(const std::string& text);
/// Reads the parts after the `=`. Leaves out single values that are equal to earlier single values. Throws UserError
/// with the name of the axis.
std::vector<StudyValues> read_values(const std::string& name, const std::string& text);

} // namespace placedpar
