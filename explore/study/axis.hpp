#pragma once

#include "explore/study/setting_value.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// Values that are written as one: a single one, or those of a range, which are never all written out.
class StudyValues {
public:
    /// Of a setting of this name: "5M", "0..7", "0..100..10" in steps of 10, "1..64..x2" each twice the one before. A
    /// range counts upwards and has its last value if a step meets it. Throws UserError where it is empty or its ends
    /// are not numbers.
    StudyValues(const std::string& name, std::string_view text);

    std::uint64_t count() const { return count_; }
    /// As --set takes it. REQUIRES: index < count().
    std::string at(std::uint64_t index) const;
    bool is_range() const { return is_range_; }
    /// Returns the value that is equal to the argument, if there is one.
    std::optional<SettingValue> find(const SettingValue&) const;

private:
    void read_range(std::string_view text, std::size_t dots);
    double steps_to(double value) const;
    void count_steps(std::string_view text, double from, double to);

    std::string name_;
    SettingValue only_; ///< the single value, where there is no range
    double from_ = 0, step_ = 1;
    bool is_range_ = false, multiplies_ = false, whole_ = true;
    std::uint64_t count_ = 1;
};

/// What a study sets, by a name as --set takes it: a val, an attribute, a parameter; to each of the values in turn.
struct StudyAxis {
    std::string name;
    std::vector<StudyValues> parts;

    /// Throws UserError where 64 bits do not hold it.
    std::uint64_t count() const;
    /// REQUIRES: index < count().
    std::string at(std::uint64_t index) const;
    /// Returns the value that is equal to the argument, if there is one.
    std::optional<SettingValue> find(const SettingValue&) const;
};

/// "slaves=0..7,10": parts with commas between them, but for those in quotes, parentheses or braces. Throws UserError.
StudyAxis read_axis(const std::string& text);
/// Parts of what stands behind the `=`; a single value that is equal to one before it is left out. Throws UserError,
/// which names the axis.
std::vector<StudyValues> read_values(const std::string& name, const std::string& text);

} // namespace placedpar
