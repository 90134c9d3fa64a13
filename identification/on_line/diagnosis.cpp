#include "identification/on_line/diagnosis.hpp"

#include "hydraulics/data/frozen_run.hpp"
#include "identification/on_line/diagnosis_state.hpp"
#include "identification/on_line/moving_diagnosis.hpp"
#include "identification/on_line/refused_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

/// The greatest deviation of the time between two readings, or two samples, from the sampling period, as a share of
/// this period. Beyond this limit, samples no longer count as equally spaced, and the windows restart.
constexpr double jitter = 0.1;

/// Returns the alarms of `a` that are not in `b`.
std::vector<Alarm> without(const std::vector<Alarm>& a, const std::vector<Alarm>& b) {
    std::vector<Alarm> rest;
    std::ranges::copy_if(a, std::back_inserter(rest),
                         [&](const Alarm& alarm) { return std::ranges::find(b, alarm) == b.end(); });
    return rest;
}

AreasFrom areas_from(const std::variant<SpoolPosition, ServoVoltage, ValveAreas>& valve) {
    if (std::holds_alternative<ServoVoltage>(valve))
        return AreasFrom::servo;
    return std::holds_alternative<SpoolPosition>(valve) ? AreasFrom::spool : AreasFrom::areas;
}

SetWatch::State& watch_of(DiagnosisState& state, LinkSet set) {
    return state.watches.try_emplace(set, SetWatch::first_state(set)).first->second;
}

Diagnosis::State first_state_of(std::string name, const ExcavatorParameters& parameters) {
    Diagnosis::State state;
    state.name = std::move(name);
    state.parameters = parameters;
    state.health_in3_per_psi = parameters.compliance_in3_per_psi;
    return state;
}

} // namespace

Diagnosis::Diagnosis(std::string name, const ExcavatorParameters& parameters, const DiagnosisSettings& settings,
                     std::uint64_t seed)
    : Diagnosis(first_state_of(std::move(name), parameters), settings, seed) {}

Diagnosis::Diagnosis(State state, const DiagnosisSettings& settings, std::uint64_t seed)
    : settings_(settings), seed_(seed), sampling_(Sampling::of(state.parameters.period_s)),
      state_(std::make_unique<State>(std::move(state))), fit_(sampling_.period_s()) {
    settings_.validate();
    for (auto& [links, set] : state_->sets)
        sets_.try_emplace(links, links, settings_, seed_, fmt::format("{}/{}", state_->name, name_of_set(links)),
                          std::move(set));
    state_->sets.clear();
    if (!state_->moving)
        return;
    make_moving();
    moving_->go_on_from(*std::exchange(state_->moving, std::nullopt));
}

const std::string& Diagnosis::name() const { return state_->name; }
const ExcavatorParameters& Diagnosis::parameters() const { return state_->parameters; }
std::optional<Configuration> Diagnosis::configuration() const { return state_->configuration; }
LinkSet Diagnosis::active() const { return state_->active; }
std::optional<double> Diagnosis::time_s() const { return state_->time_s; }
std::uint64_t Diagnosis::samples() const { return state_->samples; }
std::optional<double> Diagnosis::sample_s() const { return state_->sample_s; }
double Diagnosis::health_in3_per_psi(Link link) const { return state_->health_in3_per_psi[index_of(link)]; }
const std::vector<Alarm>& Diagnosis::alarms() const { return state_->alarms; }
void Diagnosis::connected() { state_->time_may_restart = true; }

std::optional<LinkSample> Diagnosis::centre(Link link) const {
    return state_->tracks[index_of(link)].centre(fit_, state_->parameters.links[index_of(link)]);
}

Diagnosis::Diagnosis(const Diagnosis& other)
    : settings_(other.settings_), seed_(other.seed_), sampling_(other.sampling_),
      state_(std::make_unique<State>(*other.state_)), judged_(other.judged_), fit_(other.fit_),
      moving_(other.moving_ ? std::make_unique<MovingDiagnosis>(*other.moving_) : nullptr), sets_(other.sets_),
      problems_(other.problems_) {}

Diagnosis& Diagnosis::operator=(const Diagnosis& other) { return *this = Diagnosis(other); }
Diagnosis::Diagnosis(Diagnosis&&) noexcept = default;
Diagnosis& Diagnosis::operator=(Diagnosis&&) noexcept = default;
Diagnosis::~Diagnosis() = default;

void Diagnosis::make_moving() {
    moving_ = std::make_unique<MovingDiagnosis>(state_->parameters, sampling_.period_s(), seed_, state_->name);
}

Diagnosis::State Diagnosis::state() const {
    State copy = *state_;
    for (const auto& [links, set] : sets_)
        copy.sets.emplace(links, set.state());
    if (moving_)
        copy.moving = moving_->state();
    return copy;
}

std::optional<SetEstimates> Diagnosis::estimates(LinkSet set) const {
    if (moving_)
        return moving_->estimates(set);
    auto found = sets_.find(set);
    if (found == sets_.end())
        return std::nullopt;
    const PopulationSet::State& state = found->second.state();
    return SetEstimates{set, state.window.size(), state.generations, state.estimates};
}

std::vector<SetEstimates> Diagnosis::estimates() const {
    std::vector<SetEstimates> all;
    for (LinkSet set : all_population_sets())
        if (auto found = estimates(set))
            all.push_back(*found);
    return all;
}

std::vector<LinkSet> Diagnosis::sets_in_use() const {
    if (!state_->configuration)
        return {};
    return identification::sets_in_use(*state_->configuration, state_->active);
}

PopulationSet& Diagnosis::population(LinkSet set) {
    auto [place, made] =
        sets_.try_emplace(set, set, settings_, seed_, fmt::format("{}/{}", state_->name, name_of_set(set)));
    return place->second;
}

const SetProblem& Diagnosis::problem(LinkSet set) {
    auto [place, made] = problems_.try_emplace({*state_->configuration, set}, *state_->configuration, set,
                                               state_->parameters.flow, settings_.bits);
    return place->second;
}

bool Diagnosis::can_recognise() const { return MovingDiagnosis::suits(sampling_.period_s()); }

SampleOutcome Diagnosis::change(const RecognisedConfiguration&) {
    SampleOutcome outcome;
    if (moving_)
        return outcome;
    restart_windows();
    judge(outcome); // the movements that have ended
    make_moving();
    state_->configuration = moving_->configuration();
    state_->active = {};
    return outcome;
}

SampleOutcome Diagnosis::change(const ConfigurationChange& change) {
    SampleOutcome outcome;
    if (!moving_ && state_->configuration == change.configuration && state_->active == change.active)
        return outcome;
    restart_windows(); // for the sets of the old configuration
    const bool recognised = std::exchange(moving_, nullptr) != nullptr;
    state_->configuration = change.configuration;
    state_->active = change.active;
    for (Link link : all_links)
        if (!state_->active.contains(link))
            state_->tracks[index_of(link)] = {}; // readings of an inactive link are not kept
    if (recognised)
        update_alarms(outcome);
    return outcome;
}

void Diagnosis::restart_windows() {
    state_->open = {};
    state_->sample_s.reset();
    for (LinkTrack& track : state_->tracks)
        track.restart();
    for (FrozenWatch& pressure : state_->pressures)
        pressure.restart();
    for (FrozenWatch& angle : state_->angles)
        angle.restart();
    if (moving_)
        return moving_->restart();
    for (LinkSet set : sets_in_use()) {
        end_movement(set);
        if (auto found = sets_.find(set); found != sets_.end())
            found->second.restart_window();
    }
}

LinkSet Diagnosis::read_links() const { return moving_ ? LinkSet::all() : state_->active; }

void Diagnosis::require_acceptable(const ExcavatorSample& sample) const {
    if (!state_->configuration)
        throw RefusedSample(NoConfiguration{});
    for (Link link : links_of(read_links()))
        if (!sample.links[index_of(link)])
            throw RefusedSample(LinkNotRead{link});
    if (state_->time_s && sample.time_s <= *state_->time_s && !state_->time_may_restart)
        throw RefusedSample(TimeNotLater{sample.time_s, *state_->time_s});
}

std::optional<double> Diagnosis::elapsed_s(double time_s) const {
    return state_->time_s && time_s > *state_->time_s ? std::optional(time_s - *state_->time_s) : std::nullopt;
}

bool Diagnosis::follows(std::optional<double> elapsed_s) const {
    const double late_s = jitter * sampling_.period_s();
    return elapsed_s && *elapsed_s <= sampling_.reading_s + late_s &&
           (sampling_.readings > 1 || *elapsed_s >= sampling_.reading_s - late_s);
}

void Diagnosis::read(const ExcavatorSample& sample, std::optional<double> elapsed_s) {
    if (state_->open.readings++ == 0)
        state_->open.first_s = sample.time_s;
    state_->open.after_s += sample.time_s - state_->open.first_s;
    state_->time_s = sample.time_s;
    state_->time_may_restart = false;
    ++state_->samples;
    for (Link link : links_of(read_links()))
        state_->tracks[index_of(link)].read(*sample.links[index_of(link)], state_->parameters.links[index_of(link)],
                                            elapsed_s);
}

bool Diagnosis::finish_sample(SampleOutcome& outcome) {
    if (state_->open.readings < sampling_.readings)
        return false;
    const double middle_s = state_->open.middle_s(), late_s = jitter * sampling_.period_s();
    if (sampling_.readings > 1 && state_->sample_s &&
        std::abs(middle_s - *state_->sample_s - sampling_.period_s()) > late_s) {
        outcome.window_restarted = true;
        restart_windows();
        state_->sample_s = middle_s;
        return false;
    }
    state_->open = {};
    state_->sample_s = middle_s;
    for (Link link : links_of(read_links()))
        state_->tracks[index_of(link)].finish_sample();
    return true;
}

SampleOutcome Diagnosis::take(const ExcavatorSample& sample) {
    require_acceptable(sample);
    SampleOutcome outcome;
    std::optional<double> elapsed = elapsed_s(sample.time_s);
    if (!follows(elapsed)) {
        outcome.window_restarted = state_->time_s.has_value();
        restart_windows();
    }
    read(sample, elapsed);
    watch_readings(sample);
    if (finish_sample(outcome))
        outcome.generations = moving_ ? recognise() : search(sample);
    judge(outcome);
    return outcome;
}

std::size_t Diagnosis::recognise() {
    ValveReading reading{};
    for (Link link : all_links) {
        const std::size_t i = index_of(link);
        const LinkTrack::Newest newest = state_->tracks[i].newest(state_->parameters.links[i]);
        reading.links.inlet_psi[i] = newest.inlet_psi;
        reading.links.inlet_in2[i] = newest.inlet_in2;
        reading.links.bypass_in2[i] = newest.bypass_in2;
        reading.piston_in3[i] = newest.piston_in3;
    }
    const std::size_t generations = moving_->take(reading, *state_->sample_s);
    state_->judged |= generations > 0;
    state_->configuration = moving_->configuration();
    state_->active = moving_->driven();
    return generations;
}

std::size_t Diagnosis::search(const ExcavatorSample& sample) {
    const double centre_s = *state_->sample_s - static_cast<double>(line_fit_points / 2) * sampling_.period_s();
    std::size_t generations = 0;
    for (LinkSet set : sets_in_use())
        generations += search(set, sample, centre_s);
    return generations;
}

SampleOutcome Diagnosis::end_movements() {
    SampleOutcome outcome;
    restart_windows();
    judge(outcome);
    return outcome;
}

const Movement::State* Diagnosis::movement(LinkSet set) const {
    auto found = state_->watches.find(set);
    bool moves = found != state_->watches.end() && !found->second.movement.samples.moving.empty();
    return moves ? &found->second.movement : nullptr;
}

void Diagnosis::judge(SampleOutcome& outcome) {
    outcome.judged = std::exchange(judged_, {});
    if (std::exchange(state_->judged, false))
        update_alarms(outcome);
}

std::size_t Diagnosis::search(LinkSet set, const ExcavatorSample& sample, double centre_s) {
    SetSample samples;
    for (Link link : links_of(set)) {
        auto centre = state_->tracks[index_of(link)].centre(fit_, state_->parameters.links[index_of(link)]);
        if (!centre)
            return 0;
        samples.push_back(*centre);
        if (state_->tracks[index_of(link)].spikes(sampling_.period_s()))
            note_impossible(set, link);
    }
    watch(set, samples, sample);
    return population(set).take(problem(set), samples, centre_s);
}

std::vector<double> Diagnosis::health_in3_per_psi(LinkSet set) const {
    std::vector<double> health;
    for (Link link : links_of(set))
        health.push_back(state_->health_in3_per_psi[index_of(link)]);
    return health;
}

void Diagnosis::watch(LinkSet set, const SetSample& centre, const ExcavatorSample& newest) {
    std::vector<AreasFrom> valves;
    for (Link link : links_of(set))
        valves.push_back(areas_from(newest.links[index_of(link)]->valve));
    SetWatch::State& state = watch_of(*state_, set);
    SetWatch watch(sampling_, std::move(state));
    if (watch.note_moving_shut(centre, health_in3_per_psi(set)))
        state_->judged = true;
    note(set, watch.take(problem(set), centre, valves, health_in3_per_psi(set)));
    state = watch.state();
}

void Diagnosis::end_movement(LinkSet set) {
    SetWatch::State& state = watch_of(*state_, set);
    SetWatch watch(sampling_, std::move(state));
    note(set, watch.end_movement(problem(set), health_in3_per_psi(set)));
    state = watch.state();
}

void Diagnosis::note(LinkSet set, std::optional<std::vector<Deviation>> judged) {
    if (!judged)
        return;
    state_->judged = true;
    judged_.push_back({set, std::move(*judged)});
}

bool Diagnosis::is_impossible(Link link, const Reading& reading) {
    const std::size_t fewest = fewest_frozen(sampling_.reading_s), i = index_of(link);
    const bool pressure_froze = state_->pressures[i].take(reading.inlet_psi, least_jump_psi, fewest);
    const bool angle_froze = state_->angles[i].take(reading.angle_deg, least_jump_deg, fewest);
    return pressure_froze || angle_froze || reading.inlet_psi < vacuum_psi;
}

void Diagnosis::watch_readings(const ExcavatorSample& sample) {
    for (Link link : links_of(read_links()))
        if (is_impossible(link, *sample.links[index_of(link)]))
            note_impossible(link);
}

void Diagnosis::note_impossible(Link link) {
    state_->judged = true;
    if (moving_)
        return moving_->note_impossible(link);
    for (LinkSet set : sets_in_use())
        if (set.contains(link))
            note_impossible(set, link);
}

void Diagnosis::note_impossible(LinkSet set, Link link) {
    SetWatch::State& state = watch_of(*state_, set);
    SetWatch watch(sampling_, std::move(state));
    watch.note_impossible(position_in(set, link));
    state = watch.state();
    state_->judged = true;
}

LinkVerdict Diagnosis::verdict(Link link) const {
    if (moving_)
        return moving_->verdict(link, state_->health_in3_per_psi[index_of(link)]);
    auto weight = [](const Verdict& verdict) {
        bool fault = alarm_of(verdict.kind).has_value();
        return std::pair(fault, verdict.movements);
    };
    Verdict most;
    for (const auto& [set, state] : state_->watches)
        if (set.contains(link))
            if (Verdict verdict = LinkJudge(state.judges[position_in(set, link)]).verdict();
                weight(verdict) > weight(most))
                most = verdict;
    return {most, WayUnits::of(state_->health_in3_per_psi[index_of(link)])};
}

double Diagnosis::baseline_in3_per_psi(Link link) const {
    const double health = state_->health_in3_per_psi[index_of(link)];
    if (moving_)
        return health;
    for (const auto& [set, state] : state_->watches)
        if (set.contains(link))
            if (auto own = LinkJudge(state.judges[position_in(set, link)]).baseline())
                return health + WayUnits::of(health).compliance_in3_per_psi * own->by[0];
    return health;
}

LinkCheck Diagnosis::check(Link link) const {
    LinkCheck check;
    for (const auto& [set, samples, generations, links] : estimates()) {
        if (!set.contains(link))
            continue;
        const LinkEstimate& estimate = links[position_in(set, link)];
        double settled_s = estimate.state().settled_time_s;
        if (!estimate.settled_in3_per_psi() || std::abs(*state_->time_s - settled_s) > settings_.stale_after_s)
            continue;
        check.estimates.push_back({set, *estimate.settled_in3_per_psi(), *estimate.lasting_in3_per_psi(),
                                   estimate.state().settled_in3_per_psi.size(), settled_s});
    }
    return check;
}

SampleOutcome Diagnosis::set_baseline(const Baseline& baseline) {
    for (Link link : all_links)
        if (const auto& compliance = baseline.compliance_in3_per_psi[index_of(link)]) {
            state_->health_in3_per_psi[index_of(link)] = *compliance;
            for (auto& [set, state] : state_->watches)
                if (set.contains(link))
                    state.judges[position_in(set, link)] = {};
        }
    SampleOutcome outcome;
    update_alarms(outcome);
    return outcome;
}

bool Diagnosis::stays(const Alarm& alarm) const {
    if (!moving_ || alarm.kind == AlarmKind::sensor)
        return false;
    return std::ranges::any_of(links_of(alarm.links), [&](Link link) {
        const VerdictKind kind = verdict(link).verdict.kind;
        return kind == VerdictKind::not_enough_evidence || kind == VerdictKind::cannot_tell;
    });
}

void Diagnosis::update_alarms(SampleOutcome& outcome) {
    PerLink<LinkVerdict> verdicts;
    for (Link link : all_links)
        verdicts[index_of(link)] = verdict(link);
    std::vector<Alarm> now = find_alarms(verdicts);
    for (const Alarm& alarm : without(state_->alarms, now))
        if (stays(alarm))
            now.push_back(alarm);
    outcome.raised = without(now, state_->alarms);
    outcome.cleared = without(state_->alarms, now);
    state_->alarms = std::move(now);
}

} // namespace placedpar::identification
