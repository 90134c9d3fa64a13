#include "monitor/protocol/answers.hpp"

#include "monitor/protocol/json_text.hpp"
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

/// Rounds to six digits, since no estimate is more precise.
double rounded(double value) {
    std::string text = fmt::format("{:.6g}", value);
    double result = value;
    std::from_chars(text.data(), text.data() + text.size(), result);
    return result;
}

/// Returns the time rounded to 1 us. Six digits would be too few for a time that is counted from 1970.
json::value time_json(const std::optional<double>& time_s) {
    return time_s ? json::value(std::round(*time_s * 1e6) / 1e6) : json::value(nullptr);
}

json::value number(const std::optional<double>& value) {
    return value ? json::value(rounded(*value)) : json::value(nullptr);
}

/// Returns the standard error of an estimate. Returns null without an estimate, or if its window of samples does not
/// determine the error.
json::value error(const std::optional<double>& of, double standard_error) {
    return of && std::isfinite(standard_error) ? json::value(rounded(standard_error)) : json::value(nullptr);
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
    if (!estimate.excited())
        flags.emplace_back(name_of(FlagKind::no_excitation));
    for (const Flag& flag : estimate.flags(settings))
        flags.emplace_back(name_of(flag.kind));
    if (inconsistent)
        flags.emplace_back(name_of(FlagKind::inconsistent));
    return flags;
}

json::object estimate_json(const Diagnosis& diagnosis, Link link, const LinkEstimate& estimate,
                           const DiagnosisSettings& settings) {
    const LinkEstimate::State& state = estimate.state();
    bool inconsistent = diagnosis.check(link).spread() > settings.inconsistent_over;
    json::object object{
        {"compliance_in3_per_psi", number(estimate.compliance_in3_per_psi())},
        {"standard_error_in3_per_psi", error(estimate.compliance_in3_per_psi(), state.standard_error_in3_per_psi)},
        {"settled_in3_per_psi", number(estimate.settled_in3_per_psi())},
        {"settled_error_in3_per_psi", error(estimate.settled_in3_per_psi(), state.settled_error_in3_per_psi)},
        {"time_s", estimate.compliance_in3_per_psi() ? time_json(state.time_s) : nullptr},
        {"flags", flags(estimate, inconsistent, settings)}};
    if (!diagnosis.recognises()) // a recognised machine has no window
        object["excitation_psi_per_s"] = rounded(state.excitation_psi_per_s);
    return object;
}

json::object set_json(const Diagnosis& diagnosis, const SetEstimates& set, const DiagnosisSettings& settings) {
    json::object links;
    std::vector<Link> order = links_of(set.set);
    for (std::size_t i = 0; i < order.size(); ++i)
        links[symbol_of(order[i])] = estimate_json(diagnosis, order[i], set.links[i], settings);
    return {{"window", set.samples}, {"generations", set.generations}, {"links", links}};
}

json::object verdict_json(const LinkVerdict& link) {
    const Verdict& verdict = link.verdict;
    auto by = [&](FaultHypothesis way, double unit) { return rounded(unit * verdict.deviation.by[index_of(way)]); };
    auto error = [&](FaultHypothesis way, double unit) {
        return rounded(unit * verdict.deviation.standard_error(way));
    };
    const WayUnits& units = link.units;
    // Directly measured areas have no offset.
    const bool knows_offset = verdict.deviation.by[index_of(FaultHypothesis::offset)] != 0;
    // Leaks are not judged while the configuration is recognised.
    const bool knows_leak = verdict.deviation.standard_error(FaultHypothesis::leak) > 0;
    auto known = [](bool knows, double value) { return knows ? json::value(value) : json::value(nullptr); };
    return {{"verdict", name_of(verdict.kind)},
            {"probability", rounded(verdict.probability)},
            {"movements", verdict.movements},
            {"compliance_in3_per_psi", by(FaultHypothesis::compliance, units.compliance_in3_per_psi)},
            {"compliance_error_in3_per_psi", error(FaultHypothesis::compliance, units.compliance_in3_per_psi)},
            {"leak_in3_per_s_psi", known(knows_leak, by(FaultHypothesis::leak, units.leak_in3_per_s_psi))},
            {"leak_error_in3_per_s_psi", known(knows_leak, error(FaultHypothesis::leak, units.leak_in3_per_s_psi))},
            {"offset_in", known(knows_offset, by(FaultHypothesis::offset, units.offset_in))},
            {"offset_error_in", known(knows_offset, error(FaultHypothesis::offset, units.offset_in))}};
}

json::object check_json(const Diagnosis& diagnosis, Link link) {
    const LinkCheck check = diagnosis.check(link);
    json::array estimates;
    for (const SetEstimate& each : check.estimates)
        estimates.push_back(json::object{{"set", name_of_set(each.set)},
                                         {"compliance_in3_per_psi", rounded(each.compliance_in3_per_psi)},
                                         {"lasting_in3_per_psi", rounded(each.lasting_in3_per_psi)},
                                         {"transients", each.transients},
                                         {"time_s", time_json(each.time_s)}});
    return {{"baseline_in3_per_psi", rounded(diagnosis.baseline_in3_per_psi(link))},
            {"off", verdict_json(diagnosis.verdict(link))},
            {"spread", rounded(check.spread())},
            {"estimates", std::move(estimates)}};
}

json::object alarm_json(const Alarm& alarm) {
    return {{"alarm", name_of(alarm.kind)}, {"links", symbols(alarm.links)}, {"text", alarm.text}};
}

} // namespace

std::string welcome_line(const Diagnosis& diagnosis, std::uint64_t seed) {
    return json_line({{"type", "welcome"},
                      {"version", protocol_version},
                      {"machine", diagnosis.name()},
                      {"seed", seed},
                      {"samples", diagnosis.samples()},
                      {"averaged", diagnosis.sampling().readings},
                      {"time_s", time_json(diagnosis.time_s())},
                      {"configuration", configuration_json(diagnosis)},
                      {"active", symbols(diagnosis.active())},
                      {"recognised", diagnosis.recognises()}});
}

std::string configured_line(const Diagnosis& diagnosis) {
    return json_line({{"type", "configured"},
                      {"machine", diagnosis.name()},
                      {"configuration", configuration_json(diagnosis)},
                      {"active", symbols(diagnosis.active())},
                      {"recognised", diagnosis.recognises()},
                      {"sets", set_names(diagnosis.sets_in_use())}});
}

std::string estimates_line(const Diagnosis& diagnosis, const SampleOutcome& outcome,
                           const DiagnosisSettings& settings) {
    json::object sets;
    for (LinkSet set : diagnosis.sets_in_use())
        if (auto found = diagnosis.estimates(set))
            sets[name_of_set(set)] = set_json(diagnosis, *found, settings);
    json::object answer{{"type", "estimates"},
                        {"machine", diagnosis.name()},
                        {"samples", diagnosis.samples()},
                        {"time_s", time_json(diagnosis.time_s())},
                        {"generations", outcome.generations},
                        {"window_restarted", outcome.window_restarted},
                        {"sets", std::move(sets)}};
    if (diagnosis.recognises()) {
        answer["configuration"] = configuration_json(diagnosis);
        answer["active"] = symbols(diagnosis.active());
    }
    return json_line(answer);
}

std::string alarm_line(const Diagnosis& diagnosis, const Alarm& alarm, bool raised) {
    json::object object{{"type", "alarm"},
                        {"machine", diagnosis.name()},
                        {"time_s", time_json(diagnosis.time_s())},
                        {"state", raised ? "raised" : "cleared"}};
    for (const auto& field : alarm_json(alarm))
        object[field.key()] = field.value();
    return json_line(object);
}

std::string status_line(const Diagnosis& diagnosis, const DiagnosisSettings& settings) {
    json::object sets, links;
    for (const SetEstimates& set : diagnosis.estimates())
        sets[name_of_set(set.set)] = set_json(diagnosis, set, settings);
    for (Link link : all_links)
        links[symbol_of(link)] = check_json(diagnosis, link);
    json::array alarms;
    for (const Alarm& alarm : diagnosis.alarms())
        alarms.push_back(alarm_json(alarm));
    return json_line({{"type", "status"},
                      {"machine", diagnosis.name()},
                      {"configuration", configuration_json(diagnosis)},
                      {"active", symbols(diagnosis.active())},
                      {"recognised", diagnosis.recognises()},
                      {"samples", diagnosis.samples()},
                      {"time_s", time_json(diagnosis.time_s())},
                      {"sets_in_use", set_names(diagnosis.sets_in_use())},
                      {"sets", std::move(sets)},
                      {"links", std::move(links)},
                      {"alarms", std::move(alarms)}});
}

std::string print_netlist_answer(const NetlistAnswer& answer) {
    if (!answer.wrong.empty())
        return answer.wrong;
    std::string text;
    for (std::size_t i = 0; i < answer.circuit.size(); ++i)
        text += fmt::format("{} {:.5f} in^3/psi, ", symbol_of(answer.circuit[i].link),
                            answer.found.compliance_in3_per_psi[i]);
    return fmt::format("{}{:.3f} s after the sample at {:.2f} s; keeps pace: {}", text, answer.found.after_s,
                       answer.found.sample_s, answer.found.keeps_pace ? "yes" : "no");
}

std::string netlist_line(const NetlistAnswer& answer) {
    json::object object{{"type", "netlist"},
                        {"machine", answer.machine},
                        {"set", name_of_set(answer.set)},
                        {"from_s", time_json(answer.from_s)},
                        {"to_s", time_json(answer.to_s)},
                        {"text", print_netlist_answer(answer)},
                        {"warnings", answer.found.warnings}};
    if (!answer.wrong.empty())
        return json_line(object);
    json::object links;
    for (std::size_t i = 0; i < answer.circuit.size(); ++i)
        links[symbol_of(answer.circuit[i].link)] = rounded(answer.found.compliance_in3_per_psi[i]);
    object["compliance_in3_per_psi"] = std::move(links);
    object["process"] = answer.found.process;
    object["sample_s"] = time_json(answer.found.sample_s);
    object["after_s"] = rounded(answer.found.after_s);
    object["keeps_pace"] = answer.found.keeps_pace;
    return json_line(object);
}

std::string load_line(const Load& load) {
    return json_line({{"type", "load"},
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
                      {"uptime_s", rounded(load.uptime_s)},
                      {"longest_turn_s", rounded(load.longest_turn_s)}});
}

std::string error_line(std::size_t number_of_line, const BadMessage& error) {
    return json_line({{"type", "error"},
                      {"line", number_of_line},
                      {"column", error.column() ? json::value(*error.column()) : nullptr},
                      {"field", error.field()},
                      {"wrong", error.what()},
                      {"right", error.right()}});
}

std::string kept_line(bool kept, std::string_view text) {
    return json_line({{"type", "kept"}, {"kept", kept}, {"text", text}});
}

std::string plain_line(std::string_view type, std::string_view text) {
    json::object object{{"type", type}};
    if (!text.empty())
        object["text"] = text;
    return json_line(object);
}

} // namespace placedpar::monitor
