#include "monitor/protocol/answers.hpp"

#include "monitor/protocol/message.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

namespace placedpar::monitor {

using namespace hydraulics;
using namespace identification;

namespace json = boost::json;

namespace {

/// As boost::json::serialize, but numbers as people write them.
void print(const json::value& value, std::string& text) {
    const char* separator = "";
    if (const json::object* object = value.if_object()) {
        text += '{';
        for (const auto& field : *object) {
            text += fmt::format("{}{}:", std::exchange(separator, ","), json::serialize(json::value(field.key())));
            print(field.value(), text);
        }
        text += '}';
    } else if (const json::array* array = value.if_array()) {
        text += '[';
        for (const json::value& each : *array) {
            text += std::exchange(separator, ",");
            print(each, text);
        }
        text += ']';
    } else if (const double* number = value.if_double())
        text += fmt::format("{}", *number);
    else
        text += json::serialize(value);
}

std::string line(const json::object& object) {
    std::string text;
    print(object, text);
    return text + "\n";
}

/// Six digits say more than any estimate knows.
double rounded(double value) {
    std::string text = fmt::format("{:.6g}", value);
    double result = value;
    std::from_chars(text.data(), text.data() + text.size(), result);
    return result;
}

/// To the microsecond; times may count from 1970.
json::value time_json(const std::optional<double>& time_s) {
    return time_s ? json::value(std::round(*time_s * 1e6) / 1e6) : json::value(nullptr);
}

json::value number(const std::optional<double>& value) {
    return value ? json::value(rounded(*value)) : json::value(nullptr);
}

json::array symbols(LinkSet links) {
    json::array array;
    for (Link link : links_of(links))
        array.emplace_back(symbol_of(link));
    return array;
}

json::array set_names(const std::vector<LinkSet>& sets) {
    json::array array;
    for (LinkSet set : sets)
        array.emplace_back(name_of_set(set));
    return array;
}

json::value configuration_json(const Diagnosis& diagnosis) {
    if (!diagnosis.configuration())
        return nullptr;
    return json::value(std::string(1, name_of(*diagnosis.configuration())));
}

json::array flags(const LinkEstimate& estimate, bool inconsistent, const DiagnosisSettings& settings) {
    json::array flags;
    double step = settings.step_in3_per_psi();
    if (!estimate.excited())
        flags.emplace_back("no excitation");
    if (!estimate.state().fits)
        flags.emplace_back("no fit");
    if (auto compliance = estimate.compliance_in3_per_psi()) {
        if (at_lower_bound(*compliance, step))
            flags.emplace_back("at lower bound");
        if (at_upper_bound(*compliance, step))
            flags.emplace_back("at upper bound");
    }
    if (inconsistent)
        flags.emplace_back("inconsistent");
    return flags;
}

json::object estimate_json(const Diagnosis& diagnosis, Link link, const LinkEstimate& estimate,
                           const DiagnosisSettings& settings) {
    bool inconsistent =
        std::ranges::find(diagnosis.alarms(), Alarm{AlarmKind::inconsistent, {link}, ""}) != diagnosis.alarms().end();
    return {{"compliance_in3_per_psi", number(estimate.compliance_in3_per_psi())},
            {"settled_in3_per_psi", number(estimate.settled_in3_per_psi())},
            {"excitation_psi_per_s", rounded(estimate.state().excitation_psi_per_s)},
            {"time_s", estimate.compliance_in3_per_psi() ? time_json(estimate.state().time_s) : nullptr},
            {"flags", flags(estimate, inconsistent, settings)}};
}

json::object set_json(const Diagnosis& diagnosis, const PopulationSet& set, const DiagnosisSettings& settings) {
    json::object links;
    std::vector<Link> order = links_of(set.links());
    for (std::size_t i = 0; i < order.size(); ++i)
        links[symbol_of(order[i])] = estimate_json(diagnosis, order[i], set.state().estimates[i], settings);
    return {{"window", set.state().window.size()}, {"generations", set.state().generations}, {"links", links}};
}

json::object check_json(const LinkCheck& check) {
    json::array estimates;
    for (const SetEstimate& each : check.estimates)
        estimates.push_back(json::object{{"set", name_of_set(each.set)},
                                         {"compliance_in3_per_psi", rounded(each.compliance_in3_per_psi)},
                                         {"lasting_in3_per_psi", rounded(each.lasting_in3_per_psi)},
                                         {"transients", each.transients},
                                         {"time_s", time_json(each.time_s)}});
    return {{"baseline_in3_per_psi", number(check.baseline_in3_per_psi)},
            {"spread", rounded(check.spread())},
            {"estimates", std::move(estimates)}};
}

json::object alarm_json(const Alarm& alarm) {
    return {{"alarm", name_of(alarm.kind)}, {"links", symbols(alarm.links)}, {"text", alarm.text}};
}

} // namespace

std::string welcome_line(const Diagnosis& diagnosis, std::uint64_t seed) {
    return line({{"type", "welcome"},
                 {"version", protocol_version},
                 {"machine", diagnosis.name()},
                 {"seed", seed},
                 {"samples", diagnosis.samples()},
                 {"time_s", time_json(diagnosis.time_s())},
                 {"configuration", configuration_json(diagnosis)},
                 {"active", symbols(diagnosis.active())}});
}

std::string configured_line(const Diagnosis& diagnosis) {
    return line({{"type", "configured"},
                 {"machine", diagnosis.name()},
                 {"configuration", configuration_json(diagnosis)},
                 {"active", symbols(diagnosis.active())},
                 {"sets", set_names(diagnosis.sets_in_use())}});
}

std::string estimates_line(const Diagnosis& diagnosis, const SampleOutcome& outcome,
                           const DiagnosisSettings& settings) {
    json::object sets;
    for (LinkSet set : diagnosis.sets_in_use())
        if (auto found = diagnosis.sets().find(set); found != diagnosis.sets().end())
            sets[name_of_set(set)] = set_json(diagnosis, found->second, settings);
    return line({{"type", "estimates"},
                 {"machine", diagnosis.name()},
                 {"samples", diagnosis.samples()},
                 {"time_s", time_json(diagnosis.time_s())},
                 {"generations", outcome.generations},
                 {"window_restarted", outcome.window_restarted},
                 {"sets", std::move(sets)}});
}

std::string alarm_line(const Diagnosis& diagnosis, const Alarm& alarm, bool raised) {
    json::object object{{"type", "alarm"},
                        {"machine", diagnosis.name()},
                        {"time_s", time_json(diagnosis.time_s())},
                        {"state", raised ? "raised" : "cleared"}};
    for (const auto& field : alarm_json(alarm))
        object[field.key()] = field.value();
    return line(object);
}

std::string status_line(const Diagnosis& diagnosis, const DiagnosisSettings& settings) {
    json::object sets, links;
    for (LinkSet set : all_population_sets())
        if (auto found = diagnosis.sets().find(set); found != diagnosis.sets().end())
            sets[name_of_set(set)] = set_json(diagnosis, found->second, settings);
    for (Link link : all_links)
        links[symbol_of(link)] = check_json(diagnosis.check(link));
    json::array alarms;
    for (const Alarm& alarm : diagnosis.alarms())
        alarms.push_back(alarm_json(alarm));
    return line({{"type", "status"},
                 {"machine", diagnosis.name()},
                 {"configuration", configuration_json(diagnosis)},
                 {"active", symbols(diagnosis.active())},
                 {"samples", diagnosis.samples()},
                 {"time_s", time_json(diagnosis.time_s())},
                 {"sets_in_use", set_names(diagnosis.sets_in_use())},
                 {"sets", std::move(sets)},
                 {"links", std::move(links)},
                 {"alarms", std::move(alarms)}});
}

std::string load_line(const Load& load) {
    return line({{"type", "load"},
                 {"over_s", rounded(load.rates.over_s)},
                 {"samples_per_s", rounded(load.rates.samples_per_s)},
                 {"generations_per_s", rounded(load.rates.generations_per_s)},
                 {"work_of_core", rounded(load.rates.work_of_core)},
                 {"cpu_of_core", rounded(load.rates.cpu_of_core)},
                 {"clients", load.clients},
                 {"machines", load.machines},
                 {"queued_bytes", load.queued_bytes},
                 {"samples", load.samples},
                 {"generations", load.generations},
                 {"work_s", rounded(load.work_s)},
                 {"cpu_s", rounded(load.cpu_s)},
                 {"uptime_s", rounded(load.uptime_s)}});
}

std::string error_line(std::size_t number_of_line, const BadMessage& error) {
    return line({{"type", "error"},
                 {"line", number_of_line},
                 {"column", error.column() ? json::value(*error.column()) : nullptr},
                 {"field", error.field()},
                 {"wrong", error.what()},
                 {"right", error.right()}});
}

std::string kept_line(bool kept, std::string_view text) {
    return line({{"type", "kept"}, {"kept", kept}, {"text", text}});
}

std::string plain_line(std::string_view type, std::string_view text) {
    json::object object{{"type", type}};
    if (!text.empty())
        object["text"] = text;
    return line(object);
}

} // namespace placedpar::monitor
