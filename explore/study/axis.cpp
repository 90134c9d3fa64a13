#include "explore/study/axis.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

namespace placedpar {

namespace {

constexpr double most_values = 1e15; ///< limit for a range; larger doubles do not represent all integers

[[noreturn]] void refuse_range(std::string_view text, const std::string& why) {
    throw UserError(fmt::format("{}: {}", text, why));
}

constexpr const char* forms_of_range = "a range is FROM..TO, FROM..TO..STEP or FROM..TO..xFACTOR, such as 0..7, "
                                       "0..100..10 or 1..64..x2";

/// Returns an end of a range. A suffix counts as in the clock of a processor or the speed of a link: 5M is 5 million.
double end_of_range(std::string_view range, std::string_view text) {
    std::optional<double> number = number_of_setting(std::string(text));
    if (!number)
        refuse_range(range, fmt::format("\"{}\" is not a number; {}", text, forms_of_range));
    return *number;
}

bool is_whole(double number) { return number == std::floor(number) && std::abs(number) < most_values; }

/// Returns the end of a part: a comma outside of quotes, parentheses and braces, or the end of the text.
std::size_t end_of_part(const std::string& text, std::size_t begin) {
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = begin; i < text.size(); ++i) {
        if (text[i] == '"' && (i == 0 || text[i - 1] != '\\'))
            quoted = !quoted;
        else if (!quoted && (text[i] == '(' || text[i] == '{' || text[i] == '['))
            ++depth;
        else if (!quoted && (text[i] == ')' || text[i] == '}' || text[i] == ']'))
            --depth;
        else if (text[i] == ',' && !quoted && depth <= 0)
            return i;
    }
    return text.size();
}

std::string without_blanks(std::string text) {
    text.erase(0, text.find_first_not_of(" \t"));
    text.erase(text.find_last_not_of(" \t") + 1);
    return text;
}

/// Adds a part. If an equal value is already there, only the better of the two spellings is kept.
void add_part(std::vector<StudyValues>& parts, const std::string& name, const std::string& text) {
    StudyValues part(name, text);
    SettingValue value(name, text);
    auto has_it = [&](const StudyValues& each) { return each.find(value).has_value(); };
    auto same = part.is_range() ? parts.end() : std::ranges::find_if(parts, has_it);
    if (same == parts.end())
        parts.push_back(part);
    else if (!same->is_range() && better_spelt(*same->find(value), value).spelling() == text)
        *same = part;
}

} // namespace

StudyValues::StudyValues(const std::string& name, std::string_view text) : name_(name), only_(name, std::string(text)) {
    bool begins_with_number =
        !text.empty() && (std::isdigit(static_cast<unsigned char>(text[0])) || text[0] == '-' || text[0] == '+');
    if (std::size_t dots = text.find(".."); begins_with_number && dots != text.npos)
        read_range(text, dots);
}

void StudyValues::read_range(std::string_view text, std::size_t dots) {
    std::string_view behind = text.substr(dots + 2), step = "1";
    if (std::size_t more = behind.find(".."); more != behind.npos) {
        step = behind.substr(more + 2);
        behind = behind.substr(0, more);
    }
    is_range_ = true;
    multiplies_ = step.starts_with('x');
    from_ = end_of_range(text, text.substr(0, dots));
    double to = end_of_range(text, behind);
    step_ = end_of_range(text, multiplies_ ? step.substr(1) : step);
    whole_ = is_whole(from_) && is_whole(step_);
    count_steps(text, from_, to);
}

double StudyValues::steps_to(double value) const {
    return multiplies_ ? std::log(value / from_) / std::log(step_) : (value - from_) / step_;
}

void StudyValues::count_steps(std::string_view text, double from, double to) {
    if (to < from)
        refuse_range(text, fmt::format("the range is empty: a range counts upwards, but {} is less than {}", to, from));
    if (multiplies_ ? step_ <= 1 || from <= 0 : step_ <= 0)
        refuse_range(text, multiplies_ ? "a range with a factor must begin above 0 and have a factor above 1"
                                       : "the step of a range must be more than 0");
    constexpr double rounding = 1e-9; // otherwise 0.1..0.9..0.1 could lack its last value
    double steps = steps_to(to);
    if (!(steps < most_values))
        refuse_range(text, fmt::format("the range has too many values: at most {:.0f} are allowed", most_values));
    count_ = static_cast<std::uint64_t>(std::floor(steps + rounding)) + 1;
}

std::string StudyValues::at(std::uint64_t index) const {
    if (!is_range_)
        return only_.spelling();
    auto i = static_cast<double>(index);
    double value = multiplies_ ? from_ * std::pow(step_, i) : from_ + step_ * i;
    return whole_ ? fmt::format("{:.0f}", value) : fmt::format("{:.12g}", value);
}

std::optional<SettingValue> StudyValues::find(const SettingValue& value) const {
    std::optional<double> number = is_range_ ? value.number() : std::nullopt;
    double steps = number ? steps_to(*number) : 0;
    if (is_range_ && (!number || std::isnan(steps))) // NaN if the range multiplies and the number is not above 0
        return std::nullopt;
    double nearest = std::clamp(std::round(steps), 0.0, static_cast<double>(count_ - 1)); // at() rounds
    SettingValue found = is_range_ ? SettingValue(name_, at(static_cast<std::uint64_t>(nearest))) : only_;
    return found == value ? std::optional(found) : std::nullopt;
}

std::uint64_t StudyAxis::count() const {
    std::uint64_t sum = 0;
    for (const StudyValues& part : parts) {
        if (part.count() > std::numeric_limits<std::uint64_t>::max() - sum)
            throw UserError(fmt::format("{}: the {} ranges and values have too many values to count: more than {}",
                                        name, parts.size(), std::numeric_limits<std::uint64_t>::max()));
        sum += part.count();
    }
    return sum;
}

std::string StudyAxis::at(std::uint64_t index) const {
    for (const StudyValues& part : parts) {
        if (index < part.count())
            return part.at(index);
        index -= part.count();
    }
    return "";
}

std::optional<SettingValue> StudyAxis::find(const SettingValue& value) const {
    std::optional<SettingValue> found;
    for (const StudyValues& part : parts)
        if (std::optional<SettingValue> same = part.find(value))
            found = found ? better_spelt(*found, *same) : *same;
    return found;
}

std::vector<StudyValues> read_values(const std::string& name, const std::string& text) {
    std::vector<StudyValues> values;
    for (std::size_t begin = 0; begin <= text.size();) {
        std::size_t end = end_of_part(text, begin);
        std::string part = without_blanks(text.substr(begin, end - begin));
        if (part.empty())
            throw UserError(fmt::format("{}={}: a value is missing; expected values separated by commas, or a "
                                        "range, such as {}=1,2,5 or {}=0..7",
                                        name, text, name, name));
        try {
            add_part(values, name, part);
        } catch (const UserError& refused) {
            throw UserError(fmt::format("{}={}", name, refused.what()));
        }
        begin = end + 1;
    }
    return values;
}

StudyAxis read_axis(const std::string& text) {
    std::size_t equals = text.find('=');
    if (equals == text.npos || equals == 0)
        throw UserError(fmt::format("{}: expected NAME=VALUES, such as slaves=0..7 or linkspeed=5M,10M,20M", text));
    std::string name = text.substr(0, equals);
    return {name, read_values(name, text.substr(equals + 1))};
}

} // namespace placedpar
