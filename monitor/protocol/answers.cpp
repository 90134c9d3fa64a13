#include "monitor/protocol/answers.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

namespace placedpar::monitor {

using namespace hydraulics;

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
    for (hydraulics::Link link : links_of(links))
        array.emplace_back(symbol_of(link));
    return array;
}

json::array set_names(const std::vector<LinkSet>& sets) {
    json::array array;
    for (LinkSet set : sets)
        array.emplace_back(name_of_set(set));
    return array;
}

json::value configuration_json(const Machine& machine) {
    if (!machine.configuration())
        return nullptr;
    return json::value(std::string(1, name_of(*machine.configuration())));
}

json::array flags(const Estimate& estimate, bool inconsistent, const DiagnosisSettings& settings) {
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

json::object estimate_json(const Machine& machine, hydraulics::Link link, const Estimate& estimate,
                           const DiagnosisSettings& settings) {
    bool inconsistent =
        std::ranges::find(machine.alarms(), Alarm{AlarmKind::inconsistent, {link}, ""}) != machine.alarms().end();
    return {{"compliance_in3_per_psi", number(estimate.compliance_in3_per_psi())},
            {"settled_in3_per_psi", number(estimate.settled_in3_per_psi())},
            {"excitation_psi_per_s", rounded(estimate.state().excitation_psi_per_s)},
            {"time_s", estimate.compliance_in3_per_psi() ? time_json(estimate.state().time_s) : nullptr},
            {"flags", flags(estimate, inconsistent, settings)}};
}

json::object set_json(const Machine& machine, const PopulationSet& set, const DiagnosisSettings& settings) {
    json::object links;
    std::vector<hydraulics::Link> order = links_of(set.links());
    for (std::size_t i = 0; i < order.size(); ++i)
        links[symbol_of(order[i])] = estimate_json(machine, order[i], set.state().estimates[i], settings);
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

std::string welcome_line(const Machine& machine, std::uint64_t seed) {
    return line({{"type", "welcome"},
                 {"version", protocol_version},
                 {"machine", machine.name()},
                 {"seed", seed},
                 {"samples", machine.samples()},
                 {"time_s", time_json(machine.time_s())},
                 {"configuration", configuration_json(machine)},
                 {"active", symbols(machine.active())}});
}

std::string configured_line(const Machine& machine) {
    return line({{"type", "configured"},
                 {"machine", machine.name()},
                 {"configuration", configuration_json(machine)},
                 {"active", symbols(machine.active())},
                 {"sets", set_names(machine.sets_in_use())}});
}

std::string estimates_line(const Machine& machine, const SampleOutcome& outcome, const DiagnosisSettings& settings) {
    json::object sets;
    for (LinkSet set : machine.sets_in_use())
        if (auto found = machine.sets().find(set); found != machine.sets().end())
            sets[name_of_set(set)] = set_json(machine, found->second, settings);
    return line({{"type", "estimates"},
                 {"machine", machine.name()},
                 {"samples", machine.samples()},
                 {"time_s", time_json(machine.time_s())},
                 {"generations", outcome.generations},
                 {"window_restarted", outcome.window_restarted},
                 {"sets", std::move(sets)}});
}

std::string alarm_line(const Machine& machine, const Alarm& alarm, bool raised) {
    json::object object{{"type", "alarm"},
                        {"machine", machine.name()},
                        {"time_s", time_json(machine.time_s())},
                        {"state", raised ? "raised" : "cleared"}};
    for (const auto& field : alarm_json(alarm))
        object[field.key()] = field.value();
    return line(object);
}

std::string status_line(const Machine& machine, const DiagnosisSettings& settings) {
    json::object sets, links;
    for (LinkSet set : all_population_sets())
        if (auto found = machine.sets().find(set); found != machine.sets().end())
            sets[name_of_set(set)] = set_json(machine, found->second, settings);
    for (hydraulics::Link link : all_links)
        links[symbol_of(link)] = check_json(machine.check(link));
    json::array alarms;
    for (const Alarm& alarm : machine.alarms())
        alarms.push_back(alarm_json(alarm));
    return line({{"type", "status"},
                 {"machine", machine.name()},
                 {"configuration", configuration_json(machine)},
                 {"active", symbols(machine.active())},
                 {"samples", machine.samples()},
                 {"time_s", time_json(machine.time_s())},
                 {"sets_in_use", set_names(machine.sets_in_use())},
                 {"sets", std::move(sets)},
                 {"links", std::move(links)},
                 {"alarms", std::move(alarms)}});
}

std::string load_line(const LoadMeter& meter, std::size_t clients, std::size_t machines, std::size_t queued_bytes) {
    LoadMeter::Rates rates = meter.rates();
    return line({{"type", "load"},
                 {"over_s", rounded(rates.over_s)},
                 {"samples_per_s", rounded(rates.samples_per_s)},
                 {"generations_per_s", rounded(rates.generations_per_s)},
                 {"work_of_core", rounded(rates.work_of_core)},
                 {"cpu_of_core", rounded(rates.cpu_of_core)},
                 {"clients", clients},
                 {"machines", machines},
                 {"queued_bytes", queued_bytes},
                 {"samples", meter.samples()},
                 {"generations", meter.generations()},
                 {"work_s", rounded(meter.work_s())},
                 {"cpu_s", rounded(meter.cpu_s())},
                 {"uptime_s", rounded(meter.uptime_s())}});
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
