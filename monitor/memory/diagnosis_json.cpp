#include "monitor/memory/diagnosis_json.hpp"

#include "monitor/memory/exact_text.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace placedpar::monitor {

using namespace hydraulics;
using namespace identification;

namespace json = boost::json;

namespace {

std::string text(const json::value& value) { return std::string(value.as_string()); }

json::value optional_json(const std::optional<double>& number) {
    return number ? json::value(exact_text(std::span(&*number, 1))) : json::value(nullptr);
}

double number_from(const json::value& value) {
    auto numbers = numbers_from(text(value));
    if (numbers.size() != 1)
        throw std::runtime_error(fmt::format("{} numbers where one is expected", numbers.size()));
    return numbers.front();
}

std::optional<double> optional_from(const json::value& value) {
    if (value.is_null())
        return std::nullopt;
    return number_from(value);
}

json::string links_json(LinkSet links) {
    std::string text;
    for (Link link : links_of(links))
        text += fmt::format("{}{}", text.empty() ? "" : " ", symbol_of(link));
    return json::string(text);
}

LinkSet links_from(const json::value& value) {
    LinkSet links;
    std::string symbols = text(value);
    for (Link link : all_links)
        if (symbols.find(symbol_of(link)) != std::string::npos)
            links.insert(link);
    return links;
}

// The parameters, in this order.
json::string parameters_json(const ExcavatorParameters& p) {
    std::vector<double> numbers{p.period_s, p.flow.orifice_in3_per_s_in2_sqrt_psi, p.flow.pump_in3_per_s,
                                p.flow.tank_psi, p.flow.relief_psi};
    for (const LinkConstants& link : p.links)
        numbers.insert(numbers.end(), {link.piston_in3_per_rad, link.spool_lag_per_s});
    return json::string(exact_text(numbers));
}

ExcavatorParameters parameters_from(const json::value& value) {
    std::vector<double> n = numbers_from(text(value));
    if (n.size() != 5 + 2 * all_links.size())
        throw std::runtime_error(fmt::format("{} parameters of a machine", n.size()));
    ExcavatorParameters p{n[0], {n[1], n[2], n[3], n[4]}, {}};
    for (std::size_t i = 0; i < p.links.size(); ++i)
        p.links[i] = {n[5 + 2 * i], n[6 + 2 * i]};
    return p;
}

json::object track_json(const LinkTrack::State& track) {
    return {{"inlet_psi", exact_text(track.inlet_psi)},  {"angle_deg", exact_text(track.angle_deg)},
            {"inlet_in2", exact_text(track.inlet_in2)},  {"bypass_in2", exact_text(track.bypass_in2)},
            {"spool_in", optional_json(track.spool_in)}, {"desired_in", optional_json(track.desired_in)}};
}

LinkTrack track_from(const json::value& value) {
    LinkTrack::State track{numbers_from(text(value.at("inlet_psi"))), numbers_from(text(value.at("angle_deg"))),
                           numbers_from(text(value.at("inlet_in2"))), numbers_from(text(value.at("bypass_in2"))),
                           optional_from(value.at("spool_in")),       optional_from(value.at("desired_in"))};
    std::size_t size = track.inlet_psi.size();
    if (size > line_fit_points || track.angle_deg.size() != size || track.inlet_in2.size() != size ||
        track.bypass_in2.size() != size || track.spool_in.has_value() != track.desired_in.has_value())
        throw std::runtime_error("the readings of a link do not belong together");
    return LinkTrack(std::move(track));
}

json::object estimate_json(const LinkEstimate::State& e) {
    return {{"recent", exact_text(e.recent_in3_per_psi)},
            {"settled", exact_text(e.settled_in3_per_psi)},
            {"times", exact_text(std::array{e.time_s, e.settled_time_s, e.excitation_psi_per_s})},
            {"excited", e.excited},
            {"fits", e.fits},
            {"settled_now", e.settled},
            {"generations", e.generations_in_transient}};
}

LinkEstimate estimate_from(const json::value& value) {
    std::vector<double> times = numbers_from(text(value.at("times")));
    if (times.size() != 3)
        throw std::runtime_error("an estimate without its times");
    return LinkEstimate({numbers_from(text(value.at("recent"))), numbers_from(text(value.at("settled"))), times[0],
                         times[1], times[2], value.at("excited").as_bool(), value.at("fits").as_bool(),
                         value.at("settled_now").as_bool(), value.at("generations").to_number<std::size_t>()});
}

json::string sample_json(const SetSample& sample) {
    std::vector<double> numbers;
    for (const LinkSample& s : sample)
        numbers.insert(numbers.end(),
                       {s.inlet_psi, s.inlet_slope_psi_per_s, s.piston_flow_in3_per_s, s.inlet_in2, s.bypass_in2});
    return json::string(exact_text(numbers));
}

SetSample sample_from(const json::value& value, std::size_t links) {
    std::vector<double> numbers = numbers_from(text(value));
    if (numbers.size() != links * LinkSample::channels)
        throw std::runtime_error(fmt::format("a sample of {} numbers for {} links", numbers.size(), links));
    SetSample sample;
    for (std::size_t i = 0; i < links; ++i)
        sample.push_back(LinkSample::from(std::span(numbers).subspan(i * LinkSample::channels)));
    return sample;
}

json::object set_json(LinkSet links, const PopulationSet::State& set) {
    json::array window, estimates;
    for (const SetSample& sample : set.window)
        window.push_back(sample_json(sample));
    for (const LinkEstimate& estimate : set.estimates)
        estimates.push_back(estimate_json(estimate.state()));
    return {{"set", name_of_set(links)},        {"population", exact_text(set.population)},
            {"window", std::move(window)},      {"to_skip", set.to_skip},
            {"samples", set.samples},           {"generations", set.generations},
            {"estimates", std::move(estimates)}};
}

PopulationSet::State set_from(const json::value& value, LinkSet links, const DiagnosisSettings& settings) {
    PopulationSet::State set;
    std::size_t bits = links.size() * settings.bits;
    set.population = genomes_from(text(value.at("population")), bits);
    if (set.population.size() != settings.search.population)
        throw std::runtime_error(
            fmt::format("a population of {}, expected {}", set.population.size(), settings.search.population));
    for (const json::value& sample : value.at("window").as_array())
        set.window.push_back(sample_from(sample, links.size()));
    set.to_skip = value.at("to_skip").to_number<std::size_t>();
    set.samples = value.at("samples").to_number<std::uint64_t>();
    set.generations = value.at("generations").to_number<std::uint64_t>();
    for (const json::value& estimate : value.at("estimates").as_array())
        set.estimates.push_back(estimate_from(estimate));
    if (set.estimates.size() != links.size() || set.window.size() > settings.search.window.length)
        throw std::runtime_error("the parts of a population set do not belong together");
    return set;
}

json::array alarms_json(const std::vector<Alarm>& alarms) {
    json::array array;
    for (const Alarm& alarm : alarms)
        array.push_back(
            json::object{{"alarm", name_of(alarm.kind)}, {"links", links_json(alarm.links)}, {"text", alarm.text}});
    return array;
}

Alarm alarm_from(const json::value& value) {
    std::string name = text(value.at("alarm"));
    for (AlarmKind kind : all_alarm_kinds)
        if (name == name_of(kind))
            return {kind, links_from(value.at("links")), text(value.at("text"))};
    throw std::runtime_error(fmt::format("there is no alarm \"{}\"", name));
}

} // namespace

json::object state_json(const Diagnosis::State& state) {
    json::array tracks, sets, baselines;
    for (const LinkTrack& track : state.tracks)
        tracks.push_back(track_json(track.state()));
    for (const auto& [links, set] : state.sets)
        sets.push_back(set_json(links, set));
    for (const auto& baseline : state.baseline_in3_per_psi)
        baselines.push_back(optional_json(baseline));
    return {{"machine", state.name},
            {"parameters", parameters_json(state.parameters)},
            {"configuration", state.configuration ? std::string(1, name_of(*state.configuration)) : ""},
            {"active", links_json(state.active)},
            {"time_s", optional_json(state.time_s)},
            {"time_may_restart", state.time_may_restart},
            {"samples", state.samples},
            {"tracks", std::move(tracks)},
            {"sets", std::move(sets)},
            {"baselines", std::move(baselines)},
            {"alarms", alarms_json(state.alarms)}};
}

Diagnosis::State state_from(const json::value& value, const DiagnosisSettings& settings) {
    Diagnosis::State state;
    state.name = text(value.at("machine"));
    state.parameters = parameters_from(value.at("parameters"));
    state.configuration = configuration_named(text(value.at("configuration")));
    state.active = links_from(value.at("active"));
    state.time_s = optional_from(value.at("time_s"));
    state.time_may_restart = value.at("time_may_restart").as_bool();
    state.samples = value.at("samples").to_number<std::uint64_t>();
    for (std::size_t i = 0; i < all_links.size(); ++i) {
        state.tracks[i] = track_from(value.at("tracks").as_array().at(i));
        state.baseline_in3_per_psi[i] = optional_from(value.at("baselines").as_array().at(i));
    }
    for (const json::value& set : value.at("sets").as_array()) {
        auto links = set_named(text(set.at("set")));
        if (!links)
            throw std::runtime_error(fmt::format("there is no population set \"{}\"", text(set.at("set"))));
        state.sets.emplace(*links, set_from(set, *links, settings));
    }
    for (const json::value& alarm : value.at("alarms").as_array())
        state.alarms.push_back(alarm_from(alarm));
    return state;
}

} // namespace placedpar::monitor
