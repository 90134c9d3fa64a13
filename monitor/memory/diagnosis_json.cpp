#include "monitor/memory/diagnosis_json.hpp"

#include "monitor/memory/exact_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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
    numbers.insert(numbers.end(), p.compliance_in3_per_psi.begin(), p.compliance_in3_per_psi.end());
    return json::string(exact_text(numbers));
}

ExcavatorParameters parameters_from(const json::value& value) {
    std::vector<double> n = numbers_from(text(value));
    if (n.size() != 5 + 3 * all_links.size())
        throw std::runtime_error(fmt::format("{} parameters of a machine", n.size()));
    ExcavatorParameters p{n[0], {n[1], n[2], n[3], n[4]}, {}, {}};
    for (std::size_t i = 0; i < p.links.size(); ++i)
        p.links[i] = {n[5 + 2 * i], n[6 + 2 * i]};
    std::copy_n(n.begin() + 5 + 2 * all_links.size(), all_links.size(), p.compliance_in3_per_psi.begin());
    return p;
}

json::string sums_json(const LinkTrack::Sums& sums) {
    return json::string(
        exact_text(std::array{sums.inlet_psi, sums.angle_deg, sums.spool_in, sums.inlet_in2, sums.bypass_in2,
                              static_cast<double>(sums.readings), static_cast<double>(sums.areas)}));
}

std::size_t count_from(double number) {
    constexpr double most = 1e6;
    if (!(number >= 0 && number <= most) || number != std::floor(number))
        throw std::runtime_error(fmt::format("a count of {}", number));
    return static_cast<std::size_t>(number);
}

/// None in states of before readings were averaged.
LinkTrack::Sums sums_from(const json::value* value) {
    if (!value)
        return {};
    const std::vector<double> n = numbers_from(text(*value));
    if (n.size() != 7)
        throw std::runtime_error(fmt::format("sums of {} numbers", n.size()));
    return {n[0], n[1], n[2], n[3], n[4], count_from(n[5]), n[6] != 0};
}

json::object track_json(const LinkTrack::State& track) {
    return {{"sums", sums_json(track.sums)},
            {"inlet_psi", exact_text(track.inlet_psi)},
            {"angle_deg", exact_text(track.angle_deg)},
            {"inlet_in2", exact_text(track.inlet_in2)},
            {"bypass_in2", exact_text(track.bypass_in2)},
            {"spool_in", optional_json(track.spool_in)},
            {"desired_in", optional_json(track.desired_in)}};
}

LinkTrack track_from(const json::value& value) {
    LinkTrack::State track{numbers_from(text(value.at("inlet_psi"))),
                           numbers_from(text(value.at("angle_deg"))),
                           numbers_from(text(value.at("inlet_in2"))),
                           numbers_from(text(value.at("bypass_in2"))),
                           optional_from(value.at("spool_in")),
                           optional_from(value.at("desired_in")),
                           sums_from(value.as_object().if_contains("sums"))};
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
            {"errors", exact_text(std::array{e.standard_error_in3_per_psi, e.settled_error_in3_per_psi})},
            {"excited", e.excited},
            {"fits", e.fits},
            {"settled_now", e.settled},
            {"generations", e.generations_in_transient}};
}

LinkEstimate estimate_from(const json::value& value) {
    std::vector<double> times = numbers_from(text(value.at("times")));
    std::vector<double> errors = numbers_from(text(value.at("errors")));
    if (times.size() != 3 || errors.size() != 2)
        throw std::runtime_error("an estimate without its times or its errors");
    return LinkEstimate({numbers_from(text(value.at("recent"))), numbers_from(text(value.at("settled"))), errors[0],
                         errors[1], times[0], times[1], times[2], value.at("excited").as_bool(),
                         value.at("fits").as_bool(), value.at("settled_now").as_bool(),
                         value.at("generations").to_number<std::size_t>()});
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

json::array samples_json(const std::vector<JunctionSamples>& samples) {
    json::array array;
    for (const JunctionSamples& each : samples)
        array.push_back(sample_json(each));
    return array;
}

std::vector<JunctionSamples> samples_from(const json::value& value, std::size_t links) {
    std::vector<JunctionSamples> samples;
    for (const json::value& each : value.as_array())
        samples.push_back(sample_from(each, links));
    return samples;
}

json::object movement_json(const Movement::State& movement) {
    return {{"at_rest", samples_json(movement.samples.at_rest)},
            {"moving", samples_json(movement.samples.moving)},
            {"rest_after", samples_json(movement.samples.rest_after)},
            {"shut", samples_json(movement.shut)},
            {"opened", movement.opened},
            {"closed", movement.closed}};
}

Movement::State movement_from(const json::value& value, std::size_t links, const Sampling& sampling) {
    if (!value.as_object().contains("rest_after"))
        throw OutdatedState(
            "an earlier placedpar monitor took each leak to be there before the movement, which this one "
            "does not");
    Movement::State movement{{samples_from(value.at("at_rest"), links), samples_from(value.at("moving"), links),
                              samples_from(value.at("rest_after"), links)},
                             samples_from(value.at("shut"), links),
                             value.at("opened").to_number<std::size_t>(),
                             value.at("closed").to_number<std::size_t>()};
    if (movement.samples.moving.size() >= sampling.samples_in(Movement::piece_s) ||
        movement.samples.at_rest.size() > sampling.samples_in(Movement::rest_s) ||
        movement.samples.rest_after.size() > sampling.samples_in(Movement::rest_after_s) ||
        movement.shut.size() > Movement::slope_reach)
        throw std::runtime_error("the parts of a movement do not belong together");
    return movement;
}

constexpr std::size_t numbers_of_deviation = all_ways.size() * (1 + all_ways.size());

json::string of_ways_json(const OfWays& one, const OfTwoWays& two) {
    std::vector<double> numbers(one.data(), one.data() + one.size());
    numbers.insert(numbers.end(), two.data(), two.data() + two.size());
    return json::string(exact_text(numbers));
}

json::string deviation_json(const Deviation& deviation) { return of_ways_json(deviation.by, deviation.covariance); }

/// What is inverted later has to have an inverse.
void require_invertible(const OfTwoWays& two, const char* what) {
    if (!two.allFinite() || two.llt().info() != Eigen::Success)
        throw std::runtime_error(fmt::format("{} has no inverse", what));
}

Deviation deviation_from(const json::value& value) {
    std::vector<double> numbers = numbers_from(text(value));
    if (numbers.size() != numbers_of_deviation)
        throw std::runtime_error(fmt::format("a deviation of {} numbers", numbers.size()));
    Deviation deviation;
    std::copy_n(numbers.begin(), deviation.by.size(), deviation.by.data());
    std::copy_n(numbers.begin() + deviation.by.size(), deviation.covariance.size(), deviation.covariance.data());
    return deviation;
}

json::object test_json(const SequentialTest::State& test) {
    return {{"sums", exact_text(test.sums)},
            {"informations", exact_text(test.informations)},
            {"raised", test.raised},
            {"total", of_ways_json(test.pull, test.information)},
            {"movements", test.movements}};
}

using OfSuspicions = std::array<double, SequentialTest::suspicions.size()>;
OfSuspicions of_suspicions_from(const json::value& value) {
    const std::vector<double> numbers = numbers_from(text(value));
    OfSuspicions each{};
    if (numbers.size() != each.size())
        throw std::runtime_error(fmt::format("{} numbers of {} suspicions", numbers.size(), each.size()));
    std::ranges::copy(numbers, each.begin());
    return each;
}

SequentialTest::State test_from(const json::value& value) {
    SequentialTest::State test;
    test.sums = of_suspicions_from(value.at("sums"));
    test.informations = of_suspicions_from(value.at("informations"));
    test.raised = value.at("raised").as_bool();
    const Deviation total = deviation_from(value.at("total"));
    test.pull = total.by;
    test.information = total.covariance;
    test.movements = value.at("movements").to_number<std::size_t>();
    if (test.movements > 0)
        require_invertible(test.information, "the information of a test");
    return test;
}

json::string valve_json(AreasFrom valve) {
    constexpr std::array<const char*, 3> names{"areas", "spool", "servo"};
    return names[static_cast<std::size_t>(valve)];
}

AreasFrom valve_from(const json::value& value) {
    for (AreasFrom valve : {AreasFrom::areas, AreasFrom::spool, AreasFrom::servo})
        if (value == valve_json(valve))
            return valve;
    throw std::runtime_error("a valve that is known by nothing");
}

json::object judge_json(const LinkJudge::State& judge) {
    json::array first;
    for (const Deviation& each : judge.first)
        first.push_back(deviation_json(each));
    return {{"first", std::move(first)},
            {"from_itself", test_json(judge.from_itself)},
            {"from_kind", test_json(judge.from_kind)},
            {"valve", valve_json(judge.valve)},
            {"impossible_now", judge.impossible_now},
            {"impossible", judge.impossible}};
}

LinkJudge::State judge_from(const json::value& value) {
    LinkJudge::State judge;
    for (const json::value& each : value.at("first").as_array())
        require_invertible(judge.first.emplace_back(deviation_from(each)).covariance, "the covariance of a movement");
    if (judge.first.size() > LinkJudge::movements_of_baseline)
        throw std::runtime_error("a baseline of too many movements");
    judge.from_itself = test_from(value.at("from_itself"));
    judge.from_kind = test_from(value.at("from_kind"));
    judge.valve = valve_from(value.at("valve"));
    judge.impossible_now = value.at("impossible_now").as_bool();
    judge.impossible = value.at("impossible").as_bool();
    return judge;
}

json::object watch_json(LinkSet links, const SetWatch::State& watch) {
    json::array valves, judges;
    for (AreasFrom valve : watch.valves)
        valves.push_back(valve_json(valve));
    for (const LinkJudge::State& judge : watch.judges)
        judges.push_back(judge_json(judge));
    return {{"set", name_of_set(links)},
            {"movement", movement_json(watch.movement)},
            {"valves", std::move(valves)},
            {"judges", std::move(judges)},
            {"moving_shut", json::value_from(watch.moving_shut)}};
}

SetWatch::State watch_from(const json::value& value, LinkSet links, const Sampling& sampling) {
    SetWatch::State watch{movement_from(value.at("movement"), links.size(), sampling), {}, {}, {}};
    for (const json::value& valve : value.at("valves").as_array())
        watch.valves.push_back(valve_from(valve));
    for (const json::value& judge : value.at("judges").as_array())
        watch.judges.push_back(judge_from(judge));
    for (const json::value& count : value.at("moving_shut").as_array())
        watch.moving_shut.push_back(count.to_number<std::size_t>());
    if (watch.valves.size() != links.size() || watch.judges.size() != links.size() ||
        watch.moving_shut.size() != links.size())
        throw std::runtime_error("the parts of a watched set do not belong together");
    return watch;
}

json::object frozen_json(const FrozenWatch::State& watch) {
    return {{"last", optional_json(watch.last)}, {"equal", watch.equal}, {"jump", optional_json(watch.jump)}};
}

FrozenWatch frozen_from(const json::value& value) {
    return FrozenWatch(
        {optional_from(value.at("last")), value.at("equal").to_number<std::size_t>(), number_from(value.at("jump"))});
}

LinkSet set_of(const json::value& value) {
    auto links = set_named(text(value.at("set")));
    if (!links)
        throw std::runtime_error(fmt::format("there is no population set \"{}\"", text(value.at("set"))));
    return *links;
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

json::string open_json(const OpenSample& open) {
    return json::string(exact_text(std::array{static_cast<double>(open.readings), open.first_s, open.after_s}));
}

/// Earlier versions took any period.
Sampling sampling_of(const ExcavatorParameters& parameters) {
    try {
        return Sampling::of(parameters.period_s);
    } catch (const UnfitRecord& unfit) {
        throw OutdatedState(unfit.what());
    }
}

/// Reads the sample that is being averaged. A state from a version that did not average can go on only where each
/// reading is a sample.
void read_open_sample(Diagnosis::State& state, const json::object& object, const Sampling& sampling) {
    const json::value* open = object.if_contains("open");
    if (!open && sampling.readings > 1)
        throw OutdatedState(fmt::format("its readings, {}, were judged one by one by an earlier placedpar monitor, "
                                        "which this one averages",
                                        print_sampling(sampling)));
    if (!open)
        return;
    const std::vector<double> n = numbers_from(text(*open));
    if (n.size() != 3 || !(n[0] < static_cast<double>(sampling.readings)))
        throw std::runtime_error("a sample that is whole, or no sample");
    state.open = {count_from(n[0]), n[1], n[2]};
    state.sample_s = optional_from(object.at("sample_s"));
}

} // namespace

json::object state_json(const Diagnosis::State& state) {
    json::array tracks, sets, watches, pressures, angles;
    for (const LinkTrack& track : state.tracks)
        tracks.push_back(track_json(track.state()));
    for (const auto& [links, set] : state.sets)
        sets.push_back(set_json(links, set));
    for (const auto& [links, watch] : state.watches)
        watches.push_back(watch_json(links, watch));
    for (const FrozenWatch& pressure : state.pressures)
        pressures.push_back(frozen_json(pressure.state()));
    for (const FrozenWatch& angle : state.angles)
        angles.push_back(frozen_json(angle.state()));
    return {{"machine", state.name},
            {"parameters", parameters_json(state.parameters)},
            {"configuration", state.configuration ? std::string(1, name_of(*state.configuration)) : ""},
            {"active", links_json(state.active)},
            {"time_s", optional_json(state.time_s)},
            {"time_may_restart", state.time_may_restart},
            {"samples", state.samples},
            {"open", open_json(state.open)},
            {"sample_s", optional_json(state.sample_s)},
            {"tracks", std::move(tracks)},
            {"sets", std::move(sets)},
            {"health", exact_text(state.health_in3_per_psi)},
            {"watches", std::move(watches)},
            {"pressures", std::move(pressures)},
            {"angles", std::move(angles)},
            {"judged", state.judged},
            {"alarms", alarms_json(state.alarms)}};
}

namespace {

Diagnosis::State whole_state_from(const json::value& value, const DiagnosisSettings& settings) {
    Diagnosis::State state;
    state.name = text(value.at("machine"));
    state.parameters = parameters_from(value.at("parameters"));
    state.configuration = configuration_named(text(value.at("configuration")));
    state.active = links_from(value.at("active"));
    state.time_s = optional_from(value.at("time_s"));
    state.time_may_restart = value.at("time_may_restart").as_bool();
    state.samples = value.at("samples").to_number<std::uint64_t>();
    const Sampling sampling = sampling_of(state.parameters);
    read_open_sample(state, value.as_object(), sampling);
    for (std::size_t i = 0; i < all_links.size(); ++i) {
        state.tracks[i] = track_from(value.at("tracks").as_array().at(i));
        state.pressures[i] = frozen_from(value.at("pressures").as_array().at(i));
        state.angles[i] = frozen_from(value.at("angles").as_array().at(i));
    }
    for (const json::value& set : value.at("sets").as_array()) {
        LinkSet links = set_of(set);
        state.sets.emplace(links, set_from(set, links, settings));
    }
    std::vector<double> health = numbers_from(text(value.at("health")));
    if (health.size() != all_links.size())
        throw std::runtime_error(fmt::format("{} compliances in health", health.size()));
    std::ranges::copy(health, state.health_in3_per_psi.begin());
    for (const json::value& watch : value.at("watches").as_array()) {
        LinkSet links = set_of(watch);
        state.watches.emplace(links, watch_from(watch, links, sampling));
    }
    state.judged = value.at("judged").as_bool();
    for (const json::value& alarm : value.at("alarms").as_array())
        state.alarms.push_back(alarm_from(alarm));
    return state;
}

} // namespace

Diagnosis::State state_from(const json::value& value, const DiagnosisSettings& settings) {
    try {
        return whole_state_from(value, settings);
    } catch (const std::logic_error& error) { // of a JSON value's at(), and of what is made of the values
        throw std::runtime_error(fmt::format("it is not whole: {}", error.what()));
    }
}

} // namespace placedpar::monitor
