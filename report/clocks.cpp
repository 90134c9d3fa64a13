#include "report/clocks.hpp"

#include <fmt/format.h>

namespace placedpar {

namespace {

std::string in_microseconds(Time time) { return fmt::format("{:.3f} us", static_cast<double>(time.count()) / 1e6); }

} // namespace

Table clocks_of(const std::vector<RankClock>& clocks) {
    return table_of(clocks, [](const RankClock& clock) -> Row {
        return {Field::left(0, "clock", clock.name).as("name"),
                Field::right(10, "known to", in_microseconds(clock.error)).as("error_ps", clock.error.count()),
                Field::right(10, "drift", in_microseconds(clock.drift)).as("drift_ps", clock.drift.count()),
                Field::member("ahead_of_rank_0_ns", clock.ahead.count())};
    });
}

} // namespace placedpar
