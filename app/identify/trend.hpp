#pragma once

#include "hydraulics/data/link.hpp"
#include "identification/change_test.hpp"
#include "text/diagnostic.hpp"

#include <boost/json/fwd.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace placedpar {

/// The trend shows how an excavator's links change over many records, for example of many days.

/// The values that are estimated for each link: its compliance in in^3/psi, its leak in in^3/(s psi), and the offset of
/// its spool in in.
enum class TrendValue : unsigned char { compliance, leak, offset };
inline constexpr std::array<TrendValue, 3> all_trend_values{TrendValue::compliance, TrendValue::leak,
                                                            TrendValue::offset};

std::string_view name_of(TrendValue value);
std::string_view unit_of(TrendValue value);

/// Half the length of a 95 % confidence interval, in standard errors.
inline constexpr double errors_of_interval = 1.96;

/// The values that one record gives. A value is missing if the record does not determine it.
struct RecordAnswer {
    std::string record;           ///< path as typed
    std::optional<double> date_s; ///< seconds since 1970
    hydraulics::PerLink<std::array<std::optional<identification::UncertainValue>, all_trend_values.size()>> links = {};

    std::vector<Diagnostic> warnings = {}; ///< warnings about the record
    std::string why_none = "";             ///< why a link without values has none, such as "no movement"
    /// The source of each link's areas, such as "from the spool"; "" without an answer.
    hydraulics::PerLink<std::string_view> source = {};

    const std::optional<identification::UncertainValue>& of(hydraulics::Link link, TrendValue value) const {
        return links[index_of(link)][static_cast<std::size_t>(value)];
    }
    std::optional<identification::UncertainValue>& of(hydraulics::Link link, TrendValue value) {
        return links[index_of(link)][static_cast<std::size_t>(value)];
    }
};

/// A change of one value of a link between two records.
struct TrendChange {
    hydraulics::Link link;
    TrendValue value;
    std::size_t before, after; ///< indices of the neighbouring records
    identification::SeriesChange change;
};

/// The probability that an unchanged link is reported as changed, if the standard errors are right. The test of each of
/// the three values may cause a third of it.
inline constexpr double trend_false_alarms = 0.01;

/// The answers of all records in the order of their dates, and the changes between them. If a record has no date, the
/// answers are in the order of the command line.
class Trend {
public:
    explicit Trend(std::vector<RecordAnswer> answers);

    const std::vector<RecordAnswer>& answers() const { return answers_; }
    const std::vector<TrendChange>& changes() const { return changes_; }
    bool dated() const;
    /// Returns the links with an answer.
    hydraulics::LinkSet links() const;
    /// Returns the indices of the records that determine the value.
    std::vector<std::size_t> records_of(hydraulics::Link link, TrendValue value) const;

private:
    std::vector<RecordAnswer> answers_;
    std::vector<TrendChange> changes_;
};

std::string print_trend(const Trend& trend);
boost::json::object trend_json(const Trend& trend);
/// Draws each link's compliance over the dates, and each leak and offset that changed. Throws UserError as draw_svg()
/// does.
std::string trend_svg(const Trend& trend);

} // namespace placedpar
