#include "workbench/study/sweep.hpp"

#include "runtime/random.hpp"
#include "text/user_error.hpp"
#include "workbench/load.hpp"
#include "workbench/problems.hpp"
#include "workbench/study/ranks.hpp"
#include "workbench/workers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

namespace placedpar {

namespace {

constexpr std::uint64_t most_read = 100;          ///< netlists that are looked at before a study is refused
constexpr std::uint64_t most_counted = 1'000'000; ///< runs that are looked up one by one

Network network_of(const Study& study, const Overrides& set) {
    return load_network(
        study.netlist, set, known_problems(0), [](const std::string&) {}, study.read);
}

/// None where the condition does not hold for that combination, or where it is refused, which is noted.
std::optional<Network> network_at(std::uint64_t combination, const Study& study,
                                  std::vector<std::exception_ptr>& refusals) {
    std::optional<StudyRun> run = study.at(combination * study.seeds);
    try {
        return run ? std::optional(network_of(study, run->set)) : std::nullopt;
    } catch (const UserError&) {
        refusals.push_back(std::current_exception());
        return std::nullopt;
    }
}

/// Calls `look` with networks of the study until it has seen enough: all that there are, or of very many the first, the
/// last and some that are drawn.
void look_at_networks(const Study& study, const std::function<bool(const Network&)>& look) {
    RandomStream random(0, "networks of a study");
    const std::uint64_t count = study.count() / study.seeds; // a network is that of all seeds
    for (std::uint64_t i = 0; i < std::min(count, most_read); ++i) {
        std::uint64_t drawn = (std::uint64_t{random()} << 32 | random()) % count;
        std::uint64_t network = count <= most_read || i == 0 ? i : i == 1 ? count - 1 : drawn;
        std::optional<StudyRun> run = study.at(network * study.seeds);
        try {
            if (run && look(network_of(study, run->set)))
                return;
        } catch (const UserError&) {
            continue; // there is no such machine
        }
    }
}

template <class Then, class Work>
void on_exception(Then then, Work work) {
    try {
        work();
    } catch (...) {
        then();
        throw;
    }
}

} // namespace

/// Their place stays the same: the kinds know it.
void StudyWorker::go_to_seed(std::uint64_t seed) {
    constexpr std::size_t most = 100;
    if (seed == seed_)
        return;
    if (of_others_.size() == most)
        of_others_.clear();
    auto next = of_others_.extract(seed);
    of_others_.emplace(std::exchange(seed_, seed), std::move(problems_));
    problems_ = next ? std::move(next.mapped()) : known_problems(seed);
}

void StudyWorker::go_to_network(const Overrides& set) {
    if (set_ && *set_ == set)
        return;
    set_.reset();
    go_to_seed(0); // of all netlists
    network_ = load_network(
        study_.netlist, set, kinds_, [](const std::string&) {}, study_.read);
    set_ = set;
    record_.reset();
    departed_ = 0;
}

/// Where courses depend on the seed, or cannot be repeated, that is given up after a few.
bool StudyWorker::is_worth_recording() const {
    constexpr std::uint64_t departures_at_most = 3;
    return study_.seeds > 1 && departed_ < departures_at_most && is_determinate(network_, kinds_);
}

std::optional<RunReport> StudyWorker::repeat(const RunSettings& settings) {
    std::optional<RunReport> report = repeat_netlist(network_, kinds_, *record_, settings);
    if (!report)
        ++departed_;
    else if (report->result.ending == Ending::completed)
        ++repeated_;
    return report;
}

/// A run that departs is recorded in place of the one before: the next ones may be as this one.
RunReport StudyWorker::report_of(const StudyRun& run, Interruption& interruption) {
    RunSettings settings{.seed = run.seed, .until = study_.until, .interruption = &interruption};
    if (record_ && record_->can_be_repeated())
        if (auto report = repeat(settings))
            return *report;
    record_.reset();
    if (!is_worth_recording())
        return run_netlist(network_, kinds_, settings);
    settings.record = &record_.emplace();
    RunReport report = run_netlist(network_, kinds_, settings);
    departed_ += !record_->can_be_repeated();
    return report;
}

std::optional<StudyOutcome> StudyWorker::outcome_of(const StudyRun& run, Interruption& interruption) {
    try {
        go_to_network(run.set);
        go_to_seed(run.seed);
        RunReport report = report_of(run, interruption);
        if (report.result.ending == Ending::interrupted)
            return std::nullopt;
        return StudyOutcome{.ended = name_of(report.result.ending),
                            .time = report.result.time,
                            .fingerprint = report.result.fingerprint,
                            .netlist_hash = network_.hash,
                            .figures = figures_of(report, network_)};
    } catch (const UserError& refused) {
        return StudyOutcome{.ended = "refused", .refused = refused.what()};
    }
}

Network readable_network(const Study& study) {
    std::vector<std::exception_ptr> refusals;
    const std::uint64_t count = study.count() / study.seeds; // a network is that of all seeds
    const std::uint64_t step = count / most_read + 1;
    for (std::uint64_t i = 0; i < most_read && i * step < count; ++i)
        if (auto network = network_at(i * step, study, refusals))
            return *network;
    const bool none_held = refusals.empty(); // what the condition leaves may lie between those
    for (std::uint64_t i = 0; none_held && i < std::min(count, most_counted) && refusals.size() < most_read; ++i)
        if (auto network = network_at(i, study, refusals))
            return *network;
    if (!refusals.empty())
        std::rethrow_exception(refusals.front());
    throw UserError(count > most_counted
                        ? fmt::format("the study's condition leaves none of the first {} combinations", most_counted)
                        : "the study's condition leaves nothing to be run");
}

void require_possible(const std::vector<std::string>& measures, const Study& study, const Network& network) {
    const ProblemRegistry problems = known_problems(0);
    const Catalogue kinds = known_kinds(problems);
    std::vector<StudyMeasure> missing(measures.begin(), measures.end());
    PossibleMeasures possible;
    auto all_found_with = [&](const Network& another) {
        possible.add(another, kinds, problems);
        std::erase_if(missing, [&](const StudyMeasure& each) { return possible.has(each); });
        return missing.empty();
    };
    if (!all_found_with(network))
        look_at_networks(study, all_found_with);
    if (!missing.empty())
        throw UserError(possible.there_is_no(missing.front()));
}

/// Makes it, keeps it, and notes how long it took. None when it was interrupted.
std::optional<StudyOutcome> StudySweep::timed_outcome(const StudyRun& run, Interruption& interruption) {
    if (!trier_)
        trier_.emplace(study_);
    auto begun = std::chrono::steady_clock::now();
    std::optional<StudyOutcome> outcome = trier_->outcome_of(run, interruption);
    if (outcome) {
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        tried_ = run;
        results_.keep(run, *outcome);
    }
    return outcome;
}

/// Of the first run from there on, or back, that completes. Looks at few.
std::optional<StudyFigures> StudySweep::figures_near(std::uint64_t index, bool forwards, Interruption& interruption) {
    constexpr int few = 3;
    std::uint64_t count = study_.count();
    for (int tries = 0; tries < few && index < count && !interruption.requested(); forwards ? ++index : --index) {
        std::optional<StudyRun> run = study_.at(index);
        if (!run)
            continue;
        ++tries;
        std::optional<StudyOutcome> outcome = results_.find(*run);
        if (!outcome && !(outcome = timed_outcome(*run, interruption)))
            return std::nullopt;
        if (outcome->ended == name_of(Ending::completed))
            return outcome->figures;
    }
    return std::nullopt;
}

void StudySweep::try_measures(Interruption& interruption) {
    std::vector<StudyMeasure> missing(study_.measures.begin(), study_.measures.end());
    std::optional<StudyFigures> figures;
    for (bool forwards : {true, false}) {
        std::uint64_t from = forwards ? 0 : study_.count() - 1;
        if (missing.empty() || interruption.requested())
            return;
        if (auto found = figures_near(from, forwards, interruption)) {
            figures = std::move(found);
            std::erase_if(missing, [&](const StudyMeasure& each) { return each.of(*figures).has_value(); });
        }
    }
    if (figures && !missing.empty() && !interruption.requested())
        throw UserError(there_is_no_measure(missing.front(), *figures));
}

StudySweep::Missing StudySweep::missing() {
    std::uint64_t count = study_.count(), found = 0;
    if (count > most_counted)
        return {count, false};
    for (std::uint64_t i = 0; i < count; ++i)
        if (std::optional<StudyRun> run = study_.at(i); run && !results_.has(*run))
            ++found;
    return {found, true};
}

std::optional<double> StudySweep::seconds_a_run(Interruption& interruption) {
    for (std::uint64_t i = 0; !seconds_ && i < study_.count() && !interruption.requested(); ++i)
        if (std::optional<StudyRun> run = study_.at(i))
            timed_outcome(*run, interruption);
    if (seconds_ && study_.seeds > 1 && !interruption.requested())
        time_another_seed(interruption);
    return seconds_;
}

/// The first of a combination may take longer than the others, which repeat it.
void StudySweep::time_another_seed(Interruption& interruption) {
    const double first = *seconds_, others = static_cast<double>(study_.seeds - 1);
    StudyRun another = *tried_;
    another.seed = another.seed == study_.first_seed ? another.seed + 1 : another.seed - 1;
    timed_outcome(another, interruption);
    seconds_ = (first + others * *seconds_) / (others + 1);
}

std::optional<StudyRun> StudySweep::next() {
    std::lock_guard lock(mutex_);
    for (std::uint64_t count = study_.count(); next_ < count && !stop_;) {
        std::optional<StudyRun> run = study_.at(next_++);
        if (run && !results_.has(*run))
            return run;
    }
    return std::nullopt;
}

void StudySweep::keep(const StudyRun& run, const StudyOutcome& outcome) {
    std::lock_guard lock(mutex_);
    results_.keep(run, outcome);
    ++ended_;
}

void StudySweep::work(Interruption& interruption) {
    StudyWorker worker(study_);
    while (!interruption.requested()) {
        std::optional<StudyRun> run = next();
        std::optional<StudyOutcome> outcome;
        if (!run || !(outcome = worker.outcome_of(*run, interruption)))
            return;
        keep(*run, *outcome);
    }
}

void StudySweep::run(std::size_t workers, Interruption& interruption,
                     const std::function<void(std::uint64_t ended)>& show,
                     const std::function<bool(bool stopped)>& others) {
    trier_.reset();
    std::vector<Interruption> each(workers); // of one run at a time
    auto stop = [&] {
        stop_ = true;
        std::ranges::for_each(each, &Interruption::request);
    };
    bool others_work = others != nullptr;
    auto attend = [&] {
        if (interruption.requested() || stop_)
            stop();
        show(ended_);
        if (others_work)
            on_exception(stop, [&] { others_work = others(stop_); });
    };
    const std::chrono::milliseconds often = others ? rank_patience : std::chrono::milliseconds(100);
    on_workers(
        workers, [&](std::size_t worker) { on_exception([&] { stop_ = true; }, [&] { work(each[worker]); }); }, attend,
        often);
    while (others_work) {
        std::this_thread::sleep_for(often);
        attend();
    }
}

} // namespace placedpar
