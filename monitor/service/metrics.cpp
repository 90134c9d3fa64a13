#include "monitor/service/metrics.hpp"

#include "identification/on_line/population_sets.hpp"
#include "monitor/protocol/json_text.hpp"
#include "monitor/service/alarms_json.hpp"
#include "monitor/service/clock.hpp"
#include "monitor/service/netlist_searches.hpp"

#include <boost/json.hpp>
#include <fmt/format.h>

#include <functional>
#include <optional>

namespace placedpar::monitor {

using namespace hydraulics;
using namespace identification;

namespace json = boost::json;

namespace {

/// Calls do_this(diagnosis, name of the set, link, estimate) for each estimate.
void for_each_estimate(
    const Diagnoses& diagnoses,
    const std::function<void(const Diagnosis&, std::string_view, std::string_view, const LinkEstimate&)>& do_this) {
    for (const auto& [name, diagnosis] : diagnoses.all())
        for (const SetEstimates& set : diagnosis.estimates()) {
            std::vector<Link> links = links_of(set.set);
            for (std::size_t i = 0; i < links.size(); ++i)
                do_this(diagnosis, name_of_set(set.set), symbol_of(links[i]), set.links[i]);
        }
}

/// Returns the lines of a metric that has one value for the whole service.
std::string metric(const char* name, const char* type, const char* about, double value) {
    return fmt::format(
        "# HELP placedpar_monitor_{0} {1}\n# TYPE placedpar_monitor_{0} {2}\nplacedpar_monitor_{0} {3}\n", name, about,
        type, value);
}

std::string load_metrics(const Load& load) {
    auto number = [](auto count) { return static_cast<double>(count); };
    return metric("clients", "gauge", "Connections.", number(load.clients)) +
           metric("machines", "gauge", "Machines known.", number(load.machines)) +
           metric("queued_bytes", "gauge", "Bytes waiting to be sent.", number(load.queued_bytes)) +
           metric("samples_total", "counter", "Samples taken.", number(load.samples)) +
           metric("generations_total", "counter", "Generations searched.", number(load.generations)) +
           metric("work_seconds_total", "counter", "Time spent on messages.", load.work_s) +
           metric("cpu_seconds_total", "counter", "Processor time of the thread that serves the clients, in seconds.",
                  load.cpu_s) +
           metric("uptime_seconds", "gauge", "Seconds since the start.", load.uptime_s) +
           metric("longest_turn_seconds", "gauge", "The longest time in which no client was served, in seconds.",
                  load.longest_turn_s);
}

std::string alarm_metrics(const std::vector<KeptAlarm>& alarms) {
    std::string text = "# HELP placedpar_monitor_alarm 1: the alarm is present; 0: it is present but shelved.\n# "
                       "TYPE placedpar_monitor_alarm gauge\n";
    for (const KeptAlarm& alarm : alarms)
        text += fmt::format("placedpar_monitor_alarm{{machine=\"{}\",alarm=\"{}\",links=\"{}\",acknowledged=\"{}\"}} "
                            "{}\n",
                            alarm.machine, alarm.kind, alarm.links, alarm.acknowledged_at ? "yes" : "no",
                            alarm.shelved_until && *alarm.shelved_until > now_at() ? 0 : 1);
    return text;
}

std::string compliance_metrics(const Diagnoses& diagnoses) {
    std::string text = "# HELP placedpar_monitor_compliance_in3_per_psi The newest settled compliance.\n"
                       "# TYPE placedpar_monitor_compliance_in3_per_psi gauge\n";
    for_each_estimate(diagnoses, [&](const Diagnosis& diagnosis, std::string_view set, std::string_view link,
                                     const LinkEstimate& estimate) {
        if (auto settled = estimate.settled_in3_per_psi())
            text += fmt::format(
                "placedpar_monitor_compliance_in3_per_psi{{machine=\"{}\",set=\"{}\",link=\"{}\"}} {:.6g}\n",
                diagnosis.name(), set, link, *settled);
    });
    return text;
}

json::value or_null(const std::optional<double>& number) {
    return number ? json::value(*number) : json::value(nullptr);
}

/// Returns the verdicts on the links that have been judged.
json::array verdicts_json(const Diagnosis& diagnosis) {
    json::array verdicts;
    for (Link link : all_links)
        if (const Verdict verdict = diagnosis.verdict(link).verdict; verdict.kind != VerdictKind::not_enough_evidence)
            verdicts.push_back(
                json::object{{"link", symbol_of(link)},
                             {"verdict", name_of(verdict.kind)},
                             {"sure", verdict.kind == VerdictKind::cannot_tell ? "" : how_sure(verdict.probability)}});
    return verdicts;
}

json::object machine_json(const Diagnosis& diagnosis, const NetlistSearches* searches) {
    json::value configuration;
    if (diagnosis.configuration())
        configuration = std::string(1, name_of(*diagnosis.configuration()));
    json::object healthy;
    for (Link link : all_links)
        healthy[symbol_of(link)] = diagnosis.baseline_in3_per_psi(link);
    json::array netlist;
    for (const NetlistAnswer& answer : searches ? searches->answers(diagnosis.name()) : std::vector<NetlistAnswer>{})
        netlist.push_back(json::parse(netlist_line(answer)));
    return {{"machine", diagnosis.name()},    {"healthy", healthy},
            {"samples", diagnosis.samples()}, {"time_s", or_null(diagnosis.time_s())},
            {"configuration", configuration}, {"verdicts", verdicts_json(diagnosis)},
            {"estimates", json::array()},     {"netlist", std::move(netlist)}};
}

} // namespace

std::string metrics_text(const ServiceSnapshot& snapshot) {
    return load_metrics(snapshot.load) +
           metric("kept", "gauge", "1: all state is written, so a restart would lose nothing.", snapshot.kept ? 1 : 0) +
           alarm_metrics(snapshot.alarms) + compliance_metrics(*snapshot.diagnoses);
}

std::string snapshot_json(const ServiceSnapshot& snapshot) {
    json::array machines;
    for (const auto& [name, diagnosis] : snapshot.diagnoses->all())
        machines.push_back(machine_json(diagnosis, snapshot.searches));
    std::size_t place = 0;
    for_each_estimate(*snapshot.diagnoses, [&](const Diagnosis& diagnosis, std::string_view set, std::string_view link,
                                               const LinkEstimate& estimate) {
        while (std::string_view(machines[place].at("machine").as_string()) != diagnosis.name())
            ++place;
        machines[place]
            .at("estimates")
            .as_array()
            .push_back(json::object{{"set", set},
                                    {"link", link},
                                    {"compliance", or_null(estimate.compliance_in3_per_psi())},
                                    {"settled", or_null(estimate.settled_in3_per_psi())},
                                    {"excited", estimate.excited()}});
    });
    const Load& load = snapshot.load;
    return json_line({{"at", now_at()},
                      {"kept", snapshot.kept},
                      {"trouble", snapshot.trouble},
                      {"clients", load.clients},
                      {"samples", load.samples},
                      {"samples_per_s", load.rates.samples_per_s},
                      {"cpu_of_core", load.rates.cpu_of_core},
                      {"uptime_s", load.uptime_s},
                      {"longest_turn_s", load.longest_turn_s},
                      {"machines", std::move(machines)},
                      {"alarms", alarms_json(snapshot.alarms)}});
}

std::string history_json(const std::vector<KeptEstimate>& estimates, const std::vector<KeptAlarm>& alarms) {
    json::array array;
    for (const KeptEstimate& each : estimates)
        array.push_back(json::object{{"at", each.at},
                                     {"time_s", each.time_s},
                                     {"set", each.set},
                                     {"link", each.link},
                                     {"compliance", each.compliance_in3_per_psi},
                                     {"error", or_null(each.error_in3_per_psi)}});
    return json_line({{"estimates", std::move(array)}, {"alarms", alarms_json(alarms)}});
}

} // namespace placedpar::monitor
