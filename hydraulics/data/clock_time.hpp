#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace placedpar::hydraulics {

/// A date and time of ISO 8601, as loggers write it beside each reading.
struct ClockTime {
    std::int64_t since_1970_ns; ///< nanoseconds since 1970: in UTC if the text states its zone, otherwise in the
                                ///< unknown zone of the logger
    bool has_zone;
};

/// Reads a text such as "2024-03-05T14:30:00.020Z", "2024-03-05 14:30:00,020" or "20240305T143000.02+0100". The text is
/// a date from 1900 to 2100, a "T" or a blank, and a time. Seconds or their fraction may be missing. Digits beyond
/// nanoseconds are ignored. Returns nullopt for any other text.
std::optional<ClockTime> clock_time(std::string_view text);

/// Finds the first date in the name of a file, such as "boom-2024-03-05.csv", "20240305_1430.csv" or
/// "2024-03-05T14-30-00.csv". Returns the seconds since 1970; a date without a time means midnight.
std::optional<double> date_in_name(const std::string& file_name);

/// Returns "2024-03-05 14:30", or "2024-03-05" for midnight.
std::string date_text(double since_1970_s);

} // namespace placedpar::hydraulics
