#include "app/options/time_option.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace placedpar {

namespace {

/// A unit is ten to this power of picoseconds.
std::optional<int> power_of(std::string_view unit) {
    constexpr std::pair<std::string_view, int> units[] = {{"s", 12}, {"ms", 9}, {"us", 6}, {"ns", 3}, {"ps", 0}};
    for (const auto& [name, power] : units)
        if (name == unit)
            return power;
    return std::nullopt;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Digits before and after the point; the unit.
struct TimeText {
    std::string whole, fraction, unit;
};

/// Nothing for what is not of that form.
std::optional<TimeText> split(const std::string& text) {
    TimeText parts;
    std::size_t at = 0;
    auto take_digits = [&](std::string& digits) {
        for (; at < text.size() && is_digit(text[at]); ++at)
            digits += text[at];
        return !digits.empty();
    };
    if (!take_digits(parts.whole))
        return std::nullopt;
    if (at < text.size() && text[at] == '.' && (++at, !take_digits(parts.fraction)))
        return std::nullopt;
    parts.unit = text.substr(at);
    return parts;
}

} // namespace

Time parse_time(const std::string& text) {
    std::optional<TimeText> parts = split(text);
    std::optional<int> power = parts ? power_of(parts->unit) : std::nullopt;
    if (!power)
        throw UserError(
            fmt::format("\"{}\" is no time: it takes a number and a unit of s, ms, us, ns or ps, such as 2.5ms", text));
    if (parts->fraction.size() > static_cast<std::size_t>(*power))
        throw UserError(fmt::format("\"{}\" is finer than a picosecond, the unit of virtual time", text));
    parts->fraction.resize(static_cast<std::size_t>(*power), '0');
    Time time{0};
    for (char digit : parts->whole + parts->fraction)
        time = later(times(10, time), Time{digit - '0'});
    if (time == Time::max())
        throw UserError(fmt::format("\"{}\" is beyond the end of virtual time, which lasts for 106 days", text));
    return time;
}

CLI::Option* add_time(CLI::App& command, const std::string& option, Time& time, const std::string& about) {
    auto check = [](const std::string& text) -> std::string {
        try {
            parse_time(text);
            return "";
        } catch (const UserError& refused) {
            return refused.what();
        }
    };
    return command
        .add_option_function<std::string>(
            option, [&time](const std::string& text) { time = parse_time(text); }, about)
        ->type_name("TIME")
        ->check(check);
}

} // namespace placedpar
