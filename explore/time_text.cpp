#include "explore/time_text.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <regex>
#include <string_view>
#include <utility>

namespace placedpar {

namespace {

/// Returns n if the unit is 10^n picoseconds. Returns nothing for an unknown unit.
std::optional<int> power_of(std::string_view unit) {
    constexpr std::pair<std::string_view, int> units[] = {{"s", 12}, {"ms", 9}, {"us", 6}, {"ns", 3}, {"ps", 0}};
    for (const auto& [name, power] : units)
        if (name == unit)
            return power;
    return std::nullopt;
}

/// The parts of a time such as "2.5e3us": digits before and after the point, a power of ten, the unit.
struct TimeText {
    std::string whole, fraction, unit;
    int exponent = 0;
};

/// Splits the text; returns nothing if the text is not such a time.
std::optional<TimeText> split(const std::string& text) {
    static const std::regex form(R"((\d*)(?:\.(\d+))?(?:[eE]([+-]?\d{1,3}))?([a-z]*))");
    std::smatch parts;
    if (!std::regex_match(text, parts, form) || parts.length(1) + parts.length(2) == 0)
        return std::nullopt;
    return TimeText{parts[1], parts[2], parts[4], parts.length(3) == 0 ? 0 : std::stoi(parts[3])};
}

bool is_time(const std::string& text) {
    const std::optional<TimeText> parts = split(text);
    return parts && power_of(parts->unit);
}

/// Returns the digits of the time in picoseconds. Throws UserError if the time is not a whole number of picoseconds.
std::string picoseconds(const std::string& text, const TimeText& parts, int power) {
    std::string digits = parts.whole + parts.fraction;
    int zeros = power + parts.exponent - static_cast<int>(parts.fraction.size());
    for (; zeros < 0 && digits.size() > 1 && digits.back() == '0'; ++zeros)
        digits.pop_back();
    bool is_nothing = digits.find_first_not_of('0') == digits.npos;
    if (zeros < 0 && !is_nothing)
        throw UserError(fmt::format("\"{}\" is finer than a picosecond, the unit of virtual time", text));
    return is_nothing ? "0" : digits + std::string(static_cast<std::size_t>(zeros), '0');
}

} // namespace

Time parse_time(const std::string& text) {
    std::optional<TimeText> parts = split(text);
    bool is_nothing =
        parts && parts->unit.empty() && (parts->whole + parts->fraction).find_first_not_of('0') == text.npos;
    std::optional<int> power = is_nothing ? 0 : parts ? power_of(parts->unit) : std::nullopt;
    if (!power && text.starts_with('-') && is_time(text.substr(1)))
        throw UserError(fmt::format("\"{}\" is negative: expected a time of at least 0, such as 2.5ms", text));
    if (!power)
        throw UserError(fmt::format(
            "\"{}\" is not a time: expected a number and one of the units s, ms, us, ns or ps, such as 2.5ms", text));
    Time time{0};
    for (char digit : picoseconds(text, *parts, *power))
        time = later(times(10, time), Time{digit - '0'});
    if (time == Time::max())
        throw UserError(fmt::format("\"{}\" is beyond the end of virtual time, which lasts for 106 days", text));
    return time;
}

} // namespace placedpar
