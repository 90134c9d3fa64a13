#include "identification/on_line/diagnosis.hpp"

#include "hydraulics/data/frozen_run.hpp"
#include "identification/on_line/diagnosis_state.hpp"
#include "identification/on_line/moving_diagnosis.hpp"
#include "identification/on_line/refused_sample.hpp"
#include "identification/on_line/reported_diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

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

Diagnosis::State first_state_of(std::string name, const ExcavatorParameters& parameters) {
    Diagnosis::State state;
    state.name = std::move(name);
    state.parameters = parameters;
    state.health_in3_per_psi = parameters.compliance_in3_per_psi;
    return state;
}

} // namespace

struct Diagnosis::Parts {
    State state; ///< without what the two ways keep
    ReportedDiagnosis reported;
    std::optional<MovingDiagnosis> moving; ///< nullopt: the control system reports the configuration
};

Diagnosis::Diagnosis(std::string name, const ExcavatorParameters& parameters, const DiagnosisSettings& settings,
                     std::uint64_t seed)
    : Diagnosis(first_state_of(std::move(name), parameters), settings, seed) {}

Diagnosis::Diagnosis(State state, const DiagnosisSettings& settings, std::uint64_t seed)
    : settings_(settings), seed_(seed), sampling_(Sampling::of(state.parameters.period_s)), fit_(sampling_.period_s()) {
    settings_.validate();
    ReportedDiagnosis reported(state.parameters, settings_, seed_, state.name);
    reported.report(state.configuration, state.active);
    reported.go_on_from(std::exchange(state.sets, {}), std::exchange(state.watches, {}), state.judged);
    auto moving = std::exchange(state.moving, std::nullopt);
    parts_ = std::make_unique<Parts>(Parts{std::move(state), std::move(reported), std::nullopt});
    if (moving)
        begin_moving().go_on_from(std::move(*moving));
}

Diagnosis::Diagnosis(const Diagnosis& other)
    : settings_(other.settings_), seed_(other.seed_), sampling_(other.sampling_), fit_(other.fit_),
      parts_(std::make_unique<Parts>(*other.parts_)) {}

Diagnosis& Diagnosis::operator=(const Diagnosis& other) { return *this = Diagnosis(other); }
Diagnosis::Diagnosis(Diagnosis&&) noexcept = default;
Diagnosis& Diagnosis::operator=(Diagnosis&&) noexcept = default;
Diagnosis::~Diagnosis() = default;

const DiagnosisWay& Diagnosis::way() const {
    return parts_->moving ? static_cast<const DiagnosisWay&>(*parts_->moving) : parts_->reported;
}

DiagnosisWay& Diagnosis::way() {
    return parts_->moving ? static_cast<DiagnosisWay&>(*parts_->moving) : parts_->reported;
}

MovingDiagnosis& Diagnosis::begin_moving() {
    return parts_->moving.emplace(parts_->state.parameters, sampling_.period_s(), seed_, parts_->state.name);
}

bool Diagnosis::recognises() const { return parts_->moving.has_value(); }
const std::string& Diagnosis::name() const { return parts_->state.name; }
const ExcavatorParameters& Diagnosis::parameters() const { return parts_->state.parameters; }
std::optional<Configuration> Diagnosis::configuration() const { return way().configuration(); }
LinkSet Diagnosis::active() const { return way().active(); }
std::optional<double> Diagnosis::time_s() const { return parts_->state.time_s; }
std::uint64_t Diagnosis::samples() const { return parts_->state.samples; }
std::optional<double> Diagnosis::sample_s() const { return parts_->state.sample_s; }
double Diagnosis::health_in3_per_psi(Link link) const { return parts_->state.health_in3_per_psi[index_of(link)]; }
const std::vector<Alarm>& Diagnosis::alarms() const { return parts_->state.alarms; }
void Diagnosis::connected() { parts_->state.time_may_restart = true; }
const std::map<LinkSet, PopulationSet>& Diagnosis::sets() const { return parts_->reported.sets(); }
std::optional<SetEstimates> Diagnosis::estimates(LinkSet set) const { return way().estimates(set); }
const Movement::State* Diagnosis::movement(LinkSet set) const { return parts_->reported.movement(set); }

std::optional<LinkSample> Diagnosis::centre(Link link) const {
    return parts_->state.tracks[index_of(link)].centre(fit_, parts_->state.parameters.links[index_of(link)]);
}

Diagnosis::State Diagnosis::state() const {
    State copy = parts_->state;
    copy.configuration = configuration();
    copy.active = active();
    copy.judged = way().judgements().changed;
    for (const auto& [links, set] : parts_->reported.sets())
        copy.sets.emplace(links, set.state());
    copy.watches = parts_->reported.watches();
    if (parts_->moving)
        copy.moving = parts_->moving->state();
    return copy;
}

std::vector<SetEstimates> Diagnosis::estimates() const {
    std::vector<SetEstimates> all;
    for (LinkSet set : all_population_sets())
        if (auto found = estimates(set))
            all.push_back(*found);
    return all;
}

std::vector<LinkSet> Diagnosis::sets_in_use() const {
    return configuration() ? identification::sets_in_use(*configuration(), active()) : std::vector<LinkSet>();
}

bool Diagnosis::can_recognise() const { return MovingDiagnosis::suits(sampling_.period_s()); }

SampleOutcome Diagnosis::change(const RecognisedConfiguration&) {
    SampleOutcome outcome;
    if (parts_->moving)
        return outcome;
    restart_windows();
    judge(outcome); // judges the movements that have ended
    begin_moving();
    return outcome;
}

SampleOutcome Diagnosis::change(const ConfigurationChange& change) {
    SampleOutcome outcome;
    if (!parts_->moving && configuration() == change.configuration && active() == change.active)
        return outcome;
    restart_windows(); // restarts the windows of the old configuration
    const bool recognised = std::exchange(parts_->moving, std::nullopt).has_value();
    parts_->reported.report(change.configuration, change.active);
    for (Link link : all_links)
        if (!change.active.contains(link))
            parts_->state.tracks[index_of(link)] = {}; // readings of an inactive link are not kept
    if (recognised)
        update_alarms(outcome);
    return outcome;
}

void Diagnosis::restart_windows() {
    parts_->state.open = {};
    parts_->state.sample_s.reset();
    for (LinkTrack& track : parts_->state.tracks)
        track.restart();
    for (FrozenWatch& pressure : parts_->state.pressures)
        pressure.restart();
    for (FrozenWatch& angle : parts_->state.angles)
        angle.restart();
    way().restart(parts_->state.health_in3_per_psi);
}

void Diagnosis::require_acceptable(const ExcavatorSample& sample) const {
    if (!configuration())
        throw RefusedSample(NoConfiguration{});
    for (Link link : links_of(way().read_links()))
        if (!sample.links[index_of(link)])
            throw RefusedSample(LinkNotRead{link});
    if (parts_->state.time_s && sample.time_s <= *parts_->state.time_s && !parts_->state.time_may_restart)
        throw RefusedSample(TimeNotLater{sample.time_s, *parts_->state.time_s});
}

std::optional<double> Diagnosis::elapsed_s(double time_s) const {
    return parts_->state.time_s && time_s > *parts_->state.time_s ? std::optional(time_s - *parts_->state.time_s)
                                                                  : std::nullopt;
}

bool Diagnosis::follows(std::optional<double> elapsed_s) const {
    const double late_s = jitter * sampling_.period_s();
    return elapsed_s && *elapsed_s <= sampling_.reading_s + late_s &&
           (sampling_.readings > 1 || *elapsed_s >= sampling_.reading_s - late_s);
}

void Diagnosis::read(const ExcavatorSample& sample, std::optional<double> elapsed_s) {
    if (parts_->state.open.readings++ == 0)
        parts_->state.open.first_s = sample.time_s;
    parts_->state.open.after_s += sample.time_s - parts_->state.open.first_s;
    parts_->state.time_s = sample.time_s;
    parts_->state.time_may_restart = false;
    ++parts_->state.samples;
    for (Link link : links_of(way().read_links()))
        parts_->state.tracks[index_of(link)].read(*sample.links[index_of(link)],
                                                  parts_->state.parameters.links[index_of(link)], elapsed_s);
}

bool Diagnosis::finish_sample(SampleOutcome& outcome) {
    if (parts_->state.open.readings < sampling_.readings)
        return false;
    const double middle_s = parts_->state.open.middle_s(), late_s = jitter * sampling_.period_s();
    if (sampling_.readings > 1 && parts_->state.sample_s &&
        std::abs(middle_s - *parts_->state.sample_s - sampling_.period_s()) > late_s) {
        outcome.window_restarted = true;
        restart_windows();
        parts_->state.sample_s = middle_s;
        return false;
    }
    parts_->state.open = {};
    parts_->state.sample_s = middle_s;
    for (Link link : links_of(way().read_links()))
        parts_->state.tracks[index_of(link)].finish_sample();
    return true;
}

SampleOutcome Diagnosis::take(const ExcavatorSample& sample) {
    require_acceptable(sample);
    SampleOutcome outcome;
    std::optional<double> elapsed = elapsed_s(sample.time_s);
    if (!follows(elapsed)) {
        outcome.window_restarted = parts_->state.time_s.has_value();
        restart_windows();
    }
    read(sample, elapsed);
    watch_readings(sample);
    if (finish_sample(outcome))
        outcome.generations =
            way().take({parts_->state.tracks, sample, *parts_->state.sample_s, parts_->state.health_in3_per_psi});
    judge(outcome);
    return outcome;
}

SampleOutcome Diagnosis::end_movements() {
    SampleOutcome outcome;
    restart_windows();
    judge(outcome);
    return outcome;
}

void Diagnosis::judge(SampleOutcome& outcome) {
    Judgements judgements = way().take_judgements();
    outcome.judged = std::move(judgements.movements);
    if (judgements.changed)
        update_alarms(outcome);
}

bool Diagnosis::is_impossible(Link link, const Reading& reading) {
    const std::size_t fewest = fewest_frozen(sampling_.reading_s), i = index_of(link);
    const bool pressure_froze = parts_->state.pressures[i].take(reading.inlet_psi, least_jump_psi, fewest);
    const bool angle_froze = parts_->state.angles[i].take(reading.angle_deg, least_jump_deg, fewest);
    return pressure_froze || angle_froze || reading.inlet_psi < vacuum_psi;
}

void Diagnosis::watch_readings(const ExcavatorSample& sample) {
    for (Link link : links_of(way().read_links()))
        if (is_impossible(link, *sample.links[index_of(link)]))
            way().note_impossible(link);
}

LinkVerdict Diagnosis::verdict(Link link) const { return way().verdict(link, health_in3_per_psi(link)); }

double Diagnosis::baseline_in3_per_psi(Link link) const {
    return way().baseline_in3_per_psi(link, health_in3_per_psi(link));
}

LinkCheck Diagnosis::check(Link link) const {
    LinkCheck check;
    for (const auto& [set, samples, generations, links] : estimates()) {
        if (!set.contains(link))
            continue;
        const LinkEstimate& estimate = links[position_in(set, link)];
        double settled_s = estimate.state().settled_time_s;
        if (!estimate.settled_in3_per_psi() || std::abs(*parts_->state.time_s - settled_s) > settings_.stale_after_s)
            continue;
        check.estimates.push_back({set, *estimate.settled_in3_per_psi(), *estimate.lasting_in3_per_psi(),
                                   estimate.state().settled_in3_per_psi.size(), settled_s});
    }
    return check;
}

SampleOutcome Diagnosis::set_baseline(const Baseline& baseline) {
    for (Link link : all_links)
        if (const auto& compliance = baseline.compliance_in3_per_psi[index_of(link)]) {
            parts_->state.health_in3_per_psi[index_of(link)] = *compliance;
            parts_->reported.forget(link);
        }
    SampleOutcome outcome;
    update_alarms(outcome);
    return outcome;
}

bool Diagnosis::stays(const Alarm& alarm) const {
    return alarm.kind != AlarmKind::sensor && std::ranges::any_of(links_of(alarm.links), [&](Link link) {
               return way().keeps_alarm(verdict(link).verdict.kind);
           });
}

void Diagnosis::update_alarms(SampleOutcome& outcome) {
    PerLink<LinkVerdict> verdicts;
    for (Link link : all_links)
        verdicts[index_of(link)] = verdict(link);
    std::vector<Alarm> now = find_alarms(verdicts);
    for (const Alarm& alarm : without(parts_->state.alarms, now))
        if (stays(alarm))
            now.push_back(alarm);
    outcome.raised = without(now, parts_->state.alarms);
    outcome.cleared = without(parts_->state.alarms, now);
    parts_->state.alarms = std::move(now);
}

} // namespace placedpar::identification
