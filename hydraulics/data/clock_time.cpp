#include "hydraulics/data/clock_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>

namespace placedpar::hydraulics {

namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Reads a text from left to right. After the first part that is wrong, `good` is false and nothing more is read.
class ClockText {
public:
    explicit ClockText(std::string_view text) : rest_(text) {}

    bool good = true;

    bool over() const { return rest_.empty(); }
    bool next_is(char c) const { return rest_.starts_with(c); }
    bool skip(char c) {
        const bool there = next_is(c);
        rest_.remove_prefix(there ? 1 : 0);
        return there;
    }
    /// Reads a number with exactly so many digits.
    int number(std::size_t digits, int least, int most) {
        const bool there = rest_.size() >= digits && std::ranges::all_of(rest_.substr(0, digits), is_digit);
        int value = 0;
        for (std::size_t i = 0; there && i < digits; ++i)
            value = 10 * value + (rest_[i] - '0');
        rest_.remove_prefix(there ? digits : 0);
        good = good && there && value >= least && value <= most;
        return value;
    }
    /// Reads the digits of a fraction of a second.
    std::int64_t fraction_ns() {
        good = good && !rest_.empty() && is_digit(rest_.front());
        std::int64_t ns = 0;
        for (std::int64_t digit_ns = ns_per_s / 10; !rest_.empty() && is_digit(rest_.front()); digit_ns /= 10) {
            ns += (rest_.front() - '0') * digit_ns;
            rest_.remove_prefix(1);
        }
        return ns;
    }

private:
    std::string_view rest_;
};

/// Returns the number of days since 1970.
std::int64_t days_of(ClockText& text) {
    using namespace std::chrono;
    const int year_number = text.number(4, 1700, 2200);
    const bool dashes = text.skip('-');
    const int month_number = text.number(2, 1, 12);
    text.good = text.good && text.skip('-') == dashes;
    const int day_number = text.number(2, 1, 31);
    const year_month_day date{year(year_number), month(static_cast<unsigned>(month_number)),
                              day(static_cast<unsigned>(day_number))};
    text.good = text.good && date.ok();
    return text.good ? sys_days(date).time_since_epoch().count() : 0;
}

std::int64_t time_of_day_ns(ClockText& text) {
    std::int64_t seconds = 3600 * text.number(2, 0, 23);
    const bool colons = text.skip(':');
    seconds += 60 * text.number(2, 0, 59);
    if (colons ? !text.skip(':') : text.over() || text.next_is('Z') || text.next_is('+') || text.next_is('-'))
        return seconds * ns_per_s;
    seconds += text.number(2, 0, 60); // 60: a leap second
    return seconds * ns_per_s + (text.skip('.') || text.skip(',') ? text.fraction_ns() : 0);
}

/// Returns by how much the zone's time is ahead of UTC, in s. REQUIRES: the text begins with '+' or '-'.
std::int64_t zone_s(ClockText& text) {
    const int sign = text.skip('-') ? -1 : 1;
    if (sign == 1)
        text.skip('+');
    const std::int64_t hours_s = 3600 * text.number(2, 0, 23);
    if (text.over())
        return sign * hours_s;
    text.skip(':');
    return sign * (hours_s + 60 * text.number(2, 0, 59));
}

/// Returns a date in a file's name as ISO 8601 writes it: in a name, "-" or "_" stands for "T" and ":".
std::string iso_text(std::string_view in_name) {
    std::string text(in_name);
    const std::size_t date = text.size() > 4 && text[4] == '-' ? 10 : 8;
    if (text.size() <= date)
        return text + "T00:00";
    if (text[date] == '_' || text[date] == '-')
        text[date] = 'T';
    std::replace(text.begin() + static_cast<std::ptrdiff_t>(date), text.end(), '-', ':');
    return text;
}

} // namespace

std::optional<ClockTime> clock_time(std::string_view text) {
    ClockText rest(text);
    ClockTime time{days_of(rest) * 86400 * ns_per_s, false};
    rest.good = rest.good && (rest.skip('T') || rest.skip('t') || rest.skip(' '));
    time.since_1970_ns += rest.good ? time_of_day_ns(rest) : 0;
    rest.skip(' ');
    if (rest.skip('Z') || rest.skip('z'))
        time.has_zone = true;
    else if (rest.next_is('+') || rest.next_is('-')) {
        time.has_zone = true;
        time.since_1970_ns -= zone_s(rest) * ns_per_s;
    }
    return rest.good && rest.over() ? std::optional(time) : std::nullopt;
}

std::optional<double> date_in_name(std::string_view name) {
    constexpr std::array<std::size_t, 7> lengths{19, 17, 16, 15, 13, 10, 8}; // with seconds, with minutes, date alone
    for (std::size_t at = 0; at < name.size(); ++at)
        for (std::size_t length : lengths) {
            const bool begins = at == 0 || !is_digit(name[at - 1]);
            const bool ends = at + length == name.size() || (at + length < name.size() && !is_digit(name[at + length]));
            if (!begins || !ends)
                continue;
            if (auto found = clock_time(iso_text(name.substr(at, length))))
                return static_cast<double>(found->since_1970_ns) / 1e9;
        }
    return std::nullopt;
}

std::string date_text(double since_1970_s) {
    using namespace std::chrono;
    const auto minutes_since = static_cast<std::int64_t>(std::floor(since_1970_s / 60));
    const sys_days date = floor<days>(sys_seconds(minutes(minutes_since)));
    const year_month_day parts(date);
    const std::int64_t minute = minutes_since - 1440 * date.time_since_epoch().count();
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", static_cast<int>(parts.year()),
                       static_cast<unsigned>(parts.month()), static_cast<unsigned>(parts.day()), minute / 60,
                       minute % 60);
}

} // namespace placedpar::hydraulics
