#include "app/identify/trend.hpp"

#include "explore/identify/question.hpp"
#include "hydraulics/data/clock_time.hpp"
#include "identification/on_line/population_sets.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace placedpar {

using namespace hydraulics;
using namespace identification;

namespace {

struct TrendValueName {
    std::string_view name, unit, key; ///< `key`: name in JSON
};

const TrendValueName& named(TrendValue value) {
    static constexpr std::array<TrendValueName, all_trend_values.size()> names{
        {{"compliance", "in^3/psi", "compliance_in3_per_psi"},
         {"leak", "in^3/(s psi)", "leak_in3_per_s_psi"},
         {"spool offset", "in", "offset_in"}}}; // in the order of TrendValue
    return names[static_cast<std::size_t>(value)];
}

std::string with_error(const std::optional<UncertainValue>& estimate, int decimals) {
    return estimate ? fmt::format("{:+.{}f} +- {:.{}f}", estimate->value, decimals, estimate->standard_error, decimals)
                    : "-";
}

std::string print_answer(const RecordAnswer& answer, Link link, std::size_t width) {
    const auto& found = answer.of(link, TrendValue::compliance);
    const std::string date = answer.date_s ? date_text(*answer.date_s) : "-";
    if (!found)
        return fmt::format("{:<{}}  {:<16}  no answer: {}\n", answer.record, width, date, answer.why_none);
    const double reach = errors_of_interval * found->standard_error;
    return fmt::format("{:<{}}  {:<16}  {:>7.5f}  {:<23}  {:>18}  {:>18}\n", answer.record, width, date, found->value,
                       fmt::format("{:>7.5f} to {:>7.5f}", found->value - reach, found->value + reach),
                       with_error(answer.of(link, TrendValue::leak), 4),
                       with_error(answer.of(link, TrendValue::offset), 4));
}

std::string print_change(const TrendChange& each, const Trend& trend) {
    const auto& [at, before, after, probability] = each.change;
    const double error = std::hypot(before.standard_error, after.standard_error), by = after.value - before.value;
    return fmt::format("{}: the {} {} by {:.3g} {}{}, 95 % interval {:.3g} to {:.3g}, between {} and {}: from {:.3g} "
                       "to {:.3g}; without a "
                       "change, the probability of so large a difference is {}{:.2g}\n",
                       name_of(each.link), name_of(each.value), by > 0 ? "rises" : "falls", std::abs(by),
                       unit_of(each.value),
                       each.value == TrendValue::compliance ? fmt::format(" ({:+.0f} %)", 100 * by / before.value) : "",
                       by - errors_of_interval * error, by + errors_of_interval * error,
                       trend.answers()[each.before].record, trend.answers()[each.after].record, before.value,
                       after.value, probability <= 0.0001 ? "at most " : "", probability);
}

std::string print_changes(const Trend& trend, Link link) {
    std::string text;
    for (const TrendChange& each : trend.changes())
        if (each.link == link)
            text += print_change(each, trend);
    if (text.empty())
        text = fmt::format("{}: no change of compliance, leak or spool offset is found\n", name_of(link));
    return text;
}

/// Returns whether some link has so few records that the scatter of its values cannot show whether the standard errors
/// are too small.
bool is_short(const Trend& trend) {
    return std::ranges::any_of(links_of(trend.links()), [&](Link link) {
        return trend.records_of(link, TrendValue::compliance).size() < fewest_for_scatter;
    });
}

boost::json::value estimate_json(const std::optional<UncertainValue>& estimate) {
    if (!estimate)
        return nullptr;
    return boost::json::object{{"value", estimate->value}, {"standard_error", estimate->standard_error}};
}

boost::json::object answer_json(const RecordAnswer& answer, LinkSet links) {
    boost::json::array all;
    for (Link link : links_of(links)) {
        boost::json::object& estimates = all.emplace_back(boost::json::object{{"link", name_of(link)}}).as_object();
        for (TrendValue value : all_trend_values)
            estimates[named(value).key] = estimate_json(answer.of(link, value));
    }
    return {{"record", answer.record},
            {"date", answer.date_s ? boost::json::value(date_text(*answer.date_s)) : nullptr},
            {"links", std::move(all)},
            {"why_none", answer.why_none.empty() ? boost::json::value() : boost::json::value(answer.why_none)},
            {"warnings", warnings_json(answer.warnings)}};
}

} // namespace

std::string_view name_of(TrendValue value) { return named(value).name; }
std::string_view unit_of(TrendValue value) { return named(value).unit; }

Trend::Trend(std::vector<RecordAnswer> answers) : answers_(std::move(answers)) {
    if (dated())
        std::ranges::stable_sort(answers_, {}, &RecordAnswer::date_s);
    for (Link link : links_of(links()))
        for (TrendValue value : all_trend_values) {
            const std::vector<std::size_t> records = records_of(link, value);
            std::vector<UncertainValue> series;
            for (std::size_t record : records)
                series.push_back(*answers_[record].of(link, value));
            for (const SeriesChange& change : find_changes(series, trend_false_alarms / all_trend_values.size()))
                changes_.push_back({link, value, records[change.at - 1], records[change.at], change});
        }
}

bool Trend::dated() const {
    return std::ranges::all_of(answers_, [](const RecordAnswer& each) { return each.date_s.has_value(); });
}

LinkSet Trend::links() const {
    LinkSet there;
    for (Link link : all_links)
        if (!records_of(link, TrendValue::compliance).empty())
            there.insert(link);
    return there;
}

std::vector<std::size_t> Trend::records_of(Link link, TrendValue value) const {
    std::vector<std::size_t> records;
    for (std::size_t i = 0; i < answers_.size(); ++i)
        if (answers_[i].of(link, value))
            records.push_back(i);
    return records;
}

std::string print_trend(const Trend& trend) {
    std::size_t width = 6;
    for (const RecordAnswer& each : trend.answers())
        width = std::max(width, each.record.size());
    std::string text;
    for (Link link : links_of(trend.links())) {
        text += fmt::format("{:<{}}  {:<16}  {:>7}  {:<23}  {:>18}  {:>18}\n", "record", width, "date",
                            fmt::format("C_{}i", symbol_of(link)), "95 % interval, in^3/psi", "leak, in^3/(s psi)",
                            "spool, in");
        for (const RecordAnswer& each : trend.answers())
            text += print_answer(each, link, width);
        text += "\n";
    }
    for (Link link : links_of(trend.links()))
        text += print_changes(trend, link);
    if (is_short(trend))
        text += fmt::format("with fewer than {} records only the standard errors decide whether a change is reported\n",
                            fewest_for_scatter);
    return text + fmt::format("{}the test reports a change for {:.0f} % of the links that do not change\n",
                              trend.dated() ? ""
                                            : "not every record has a date, so the records are in the order of the "
                                              "command line\n",
                              100 * trend_false_alarms);
}

boost::json::object trend_json(const Trend& trend) {
    boost::json::array records, changes;
    for (const RecordAnswer& each : trend.answers())
        records.push_back(answer_json(each, trend.links()));
    for (const TrendChange& each : trend.changes())
        changes.push_back(boost::json::object{{"link", name_of(each.link)},
                                              {"what", name_of(each.value)},
                                              {"unit", unit_of(each.value)},
                                              {"after", trend.answers()[each.before].record},
                                              {"until", trend.answers()[each.after].record},
                                              {"before", each.change.before.value},
                                              {"now", each.change.after.value},
                                              {"probability", each.change.probability}});
    return {{"false_alarms", trend_false_alarms}, {"records", std::move(records)}, {"changes", std::move(changes)}};
}

} // namespace placedpar
