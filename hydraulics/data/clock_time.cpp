#include "hydraulics/data/clock_time.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <initializer_list>
#include <iterator>
#include <regex>

namespace placedpar::hydraulics {

namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns whether the text has one of these shapes, in which "0" stands for any digit.
bool has_shape(std::string_view text, std::initializer_list<std::string_view> shapes) {
    return std::ranges::any_of(shapes, [text](std::string_view shape) {
        return std::ranges::equal(text, shape, {}, [](char c) { return is_digit(c) ? '0' : c; });
    });
}

/// Returns the number that `count` digits of a text form, beginning with its digit `first`. Returns 0 if the text has
/// fewer digits. Other characters are skipped.
int number_of(std::string_view text, std::size_t first, std::size_t count) {
    std::string digits;
    std::ranges::copy_if(text, std::back_inserter(digits), is_digit);
    int number = 0;
    for (std::size_t i = first; first + count <= digits.size() && i < first + count; ++i)
        number = 10 * number + (digits[i] - '0');
    return number;
}

/// Returns the nanoseconds from 1970 to the beginning of the day, or nullopt if the calendar has no such day.
std::optional<std::int64_t> day_ns(std::string_view text) {
    using namespace std::chrono;
    const int in_year = number_of(text, 0, 4);
    const year_month_day date{year(in_year), month(static_cast<unsigned>(number_of(text, 4, 2))),
                              day(static_cast<unsigned>(number_of(text, 6, 2)))};
    if (!has_shape(text, {"0000-00-00", "00000000"}) || in_year < 1900 || in_year > 2100 || !date.ok())
        return std::nullopt;
    return sys_days(date).time_since_epoch().count() * 86400 * ns_per_s;
}

/// Returns the nanoseconds from midnight to a time such as "14:30:00" or "143000".
std::optional<std::int64_t> time_of_day_ns(std::string_view text) {
    const int hours = number_of(text, 0, 2), minutes = number_of(text, 2, 2), seconds = number_of(text, 4, 2);
    if (!has_shape(text, {"00:00", "00:00:00", "0000", "000000"}) || hours > 23 || minutes > 59 || seconds > 60)
        return std::nullopt; // 60 s: a leap second
    return (3600 * hours + 60 * minutes + seconds) * ns_per_s;
}

/// Returns the nanoseconds of a fraction of a second such as ".02" or "".
std::optional<std::int64_t> fraction_ns(std::string_view text) {
    if (text.size() == 1 || (!text.empty() && !std::ranges::all_of(text.substr(1), is_digit)))
        return std::nullopt;
    std::string nine(text);
    nine.resize(10, '0');
    return number_of(nine, text.empty() ? 1 : 0, 9);
}

/// Returns the nanoseconds by which a time zone such as "+01:00" is ahead of UTC.
std::optional<std::int64_t> zone_ns(std::string_view text) {
    const int hours = number_of(text, 0, 2), minutes = number_of(text, 2, 2);
    if (has_shape(text, {"", "Z", "z"}))
        return 0;
    if (!has_shape(text.substr(1), {"00", "0000", "00:00"}) || hours > 23 || minutes > 59)
        return std::nullopt;
    return (text.front() == '-' ? -1 : 1) * (3600 * hours + 60 * minutes) * ns_per_s;
}

} // namespace

std::optional<ClockTime> clock_time(std::string_view text) {
    const std::size_t mark = text.size() > 4 && text[4] == '-' ? 10 : 8;
    if (text.size() <= mark || std::string_view("Tt ").find(text[mark]) == std::string_view::npos)
        return std::nullopt;
    const std::string_view rest = text.substr(mark + 1);
    const std::string_view zone = rest.substr(std::min(rest.find_first_of("Zz+-"), rest.size()));
    std::string_view time = rest.substr(0, rest.size() - zone.size());
    if (!zone.empty() && time.ends_with(' '))
        time.remove_suffix(1);
    const std::size_t point = std::min(time.find_first_of(".,"), time.size());
    const auto day = day_ns(text.substr(0, mark)), since_midnight = time_of_day_ns(time.substr(0, point)),
               fraction = fraction_ns(time.substr(point)), ahead = zone_ns(zone);
    if (!day || !since_midnight || !fraction || !ahead)
        return std::nullopt;
    return ClockTime{*day + *since_midnight + *fraction - *ahead, !zone.empty()};
}

std::optional<double> date_in_name(const std::string& name) {
    static const std::regex date("(?:^|[^0-9])([0-9]{4}-?[0-9]{2}-?[0-9]{2})"
                                 "(?:[T_-]([0-9]{2})[-:]?([0-9]{2})(?:[-:]?([0-9]{2}))?)?(?![0-9])");
    for (std::sregex_iterator found(name.begin(), name.end(), date), end; found != end; ++found)
        for (const std::string& time :
             {fmt::format("{}:{}:{}", found->str(2), found->str(3), (*found)[4].matched ? found->str(4) : "00"),
              std::string("00:00")})
            if (const auto read = clock_time(found->str(1) + "T" + time))
                return static_cast<double>(read->since_1970_ns) / 1e9;
    return std::nullopt;
}

std::string date_text(double since_1970_s) {
    const auto minutes = static_cast<std::time_t>(std::floor(since_1970_s / 60));
    const std::tm time = fmt::gmtime(60 * minutes);
    return minutes % 1440 == 0 ? fmt::format("{:%Y-%m-%d}", time) : fmt::format("{:%Y-%m-%d %H:%M}", time);
}

} // namespace placedpar::hydraulics
