#include "explore/study/sweep.hpp"

#include "explore/load.hpp"
#include "explore/problems.hpp"
#include "explore/workers.hpp"
#include "ranks/ranks.hpp"
#include "text/paint.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <numeric>
#include <set>
#include <string>
#include <thread>
#include <utility>

namespace placedpar {

namespace {

constexpr std::uint64_t most_read = 100;          ///< combinations that are read if there are very many
constexpr std::uint64_t most_refused = 300;       ///< as `most_read`, if combinations are refused for different reasons
constexpr std::uint64_t most_counted = 1'000'000; ///< largest number of runs for which each run is looked up

/// Collects the combinations that cannot be read.
class Refusals {
public:
    /// Adds a refusal. REQUIRES: called from the handler that caught it.
    void add(const UserError& refused) {
        if (count_++ == 0)
            first_ = std::current_exception();
        said_.insert(refused.what());
    }
    std::uint64_t count() const { return count_; }
    /// Returns whether other combinations may still be readable: only few have been refused, or the reasons differ.
    bool leave_hope() const { return count_ < most_read || (said_.size() > 1 && count_ < most_refused); }
    void rethrow_first() const { std::rethrow_exception(first_); }

private:
    std::uint64_t count_ = 0;
    std::exception_ptr first_;
    std::set<std::string> said_;
};

/// Reads the netlist with combinations of a study's settings.
class NetworkReader {
public:
    explicit NetworkReader(const Study& study)
        : seeds_(study.seeds), runs_(study), netlist_(study.netlist, study.read) {}
    NetworkReader(const NetworkReader&) = delete; // not copied: the kinds refer to the problems

    /// Returns the network. Returns nothing if the condition does not hold for the combination. If the network is
    /// refused, adds the refusal to `refusals` and returns nothing.
    std::optional<Network> at(std::uint64_t combination, Refusals& refusals) const {
        std::optional<StudyRun> run = runs_.at(combination * seeds_);
        try {
            return run ? std::optional(load_network(netlist_, run->set, kinds_, [](const std::string&) {}))
                       : std::nullopt;
        } catch (const UserError& refused) {
            refusals.add(refused);
            return std::nullopt;
        }
    }

private:
    const std::uint64_t seeds_;
    const StudyRuns runs_;
    const ParsedNetlist netlist_;
    const ProblemRegistry problems_ = known_problems(0);
    const Catalogue kinds_ = known_kinds(problems_);
};

/// Yields all combinations of a study, beginning with the first and the last. At any time, the combinations so far are
/// spread evenly over the study, because the step is the number of combinations times the golden ratio.
class SpreadCombinations {
public:
    explicit SpreadCombinations(const Study& study) : count_(study.count() / study.seeds) {
        constexpr double golden = 0.6180339887498949;
        step_ = std::max<std::uint64_t>(static_cast<std::uint64_t>(golden * static_cast<double>(count_)), 1);
        while (std::gcd(step_, count_) != 1)
            ++step_;
    }
    /// Returns the next combination; nothing when all have been returned. The combination with the greatest number is
    /// returned twice.
    std::optional<std::uint64_t> next() {
        if (given_ > count_)
            return std::nullopt;
        if (given_++ == 1)
            return count_ - 1;
        std::uint64_t left = count_ - at_; // avoids overflow of the sum
        return std::exchange(at_, step_ < left ? at_ + step_ : step_ - left);
    }

private:
    std::uint64_t count_, step_ = 1, at_ = 0, given_ = 0;
};

/// Calls `look` with networks of the study until it returns true. If there are very many networks, calls it only with
/// some networks that are spread over the study.
void look_at_networks(const Study& study, const std::function<bool(const Network&)>& look) {
    const NetworkReader reader(study);
    SpreadCombinations combinations(study);
    Refusals refusals; // ignored: refused combinations have no network
    for (std::uint64_t looked_at = 0; looked_at <= most_read; ++looked_at) {
        std::optional<std::uint64_t> combination = combinations.next();
        std::optional<Network> network = combination ? reader.at(*combination, refusals) : std::nullopt;
        if (!combination || (network && look(*network)))
            return;
    }
}

/// Makes runs in one thread, as StudyWorker::outcome_of() does.
using RunMaker = std::function<std::optional<StudyOutcome>(const StudyRun&, Interruption&)>;

RunMaker maker_of(const Study& study) {
    if (study.function)
        return [&](const StudyRun& run, Interruption&) {
            return StudyOutcome{.ended = name_of(RunOutcome::completed), .figures = study.function(run)};
        };
    return [worker = std::make_shared<StudyWorker>(study)](const StudyRun& run, Interruption& interruption) {
        return worker->outcome_of(run, interruption);
    };
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

ProblemRegistry StudyWorker::problems_of(std::uint64_t seed) {
    return known_problems(seed, [this](const ProblemFamily& family) { return remembered_.around(family); });
}

/// Replaces the problems in place, because the kinds hold a reference to the problems.
void StudyWorker::go_to_seed(std::uint64_t seed) {
    constexpr std::size_t most = 100;
    if (seed == seed_)
        return;
    if (of_others_.size() == most)
        of_others_.clear();
    auto next = of_others_.extract(seed);
    of_others_.emplace(std::exchange(seed_, seed), std::move(problems_));
    problems_ = next ? std::move(next.mapped()) : problems_of(seed);
}

void StudyWorker::go_to_network(const Overrides& set) {
    if (set_ && *set_ == set)
        return;
    set_.reset();
    go_to_seed(0); // networks are read with seed 0
    network_ = load_network(netlist_, set, kinds_, [](const std::string&) {});
    set_ = set;
    record_.reset();
    departed_ = 0;
}

/// Returns whether to record the next run. If runs differ between seeds or cannot be repeated, recording stops after a
/// few runs.
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

/// Makes a run, if possible by repeating the record. If the run differs from the record, the run becomes the new
/// record, because later runs may equal this run.
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
        return StudyOutcome{.ended = name_of(report.outcome()),
                            .time = report.result.time,
                            .fingerprint = report.result.fingerprint,
                            .netlist_hash = network_.hash,
                            .figures = figures_of(report, network_, study_.prices)};
    } catch (const UserError& refused) {
        return StudyOutcome{.ended = "refused", .refused = unpainted(refused.what())};
    }
}

Network readable_network(const Study& study) {
    const std::uint64_t count = study.count() / study.seeds; // all seeds of a combination have one network
    const NetworkReader reader(study);
    Refusals refusals;
    SpreadCombinations combinations(study);
    for (std::uint64_t looked_at = 0; looked_at < most_refused && refusals.leave_hope(); ++looked_at) {
        std::optional<std::uint64_t> combination = combinations.next();
        if (!combination)
            break;
        if (auto network = reader.at(*combination, refusals))
            return *network;
    }
    const bool none_held = refusals.count() == 0; // combinations not read so far may satisfy the condition
    for (std::uint64_t i = 0; none_held && i < std::min(count, most_counted) && refusals.leave_hope(); ++i)
        if (auto network = reader.at(i, refusals))
            return *network;
    if (refusals.count() > 0)
        refusals.rethrow_first();
    throw UserError(count > most_counted
                        ? fmt::format("none of the first {} combinations satisfies the study's condition", most_counted)
                        : "no combination satisfies the study's condition");
}

void require_possible(const std::vector<std::string>& measures, const Study& study, const Network& network) {
    const ProblemRegistry problems = known_problems(0);
    const Catalogue kinds = known_kinds(problems);
    std::vector<StudyMeasure> missing(measures.begin(), measures.end());
    require_parts(study.prices, kinds);
    PossibleMeasures possible;
    if (!study.prices.empty())
        possible.add("price");
    auto all_found_with = [&](const Network& another) {
        possible.add(another, kinds, problems);
        std::erase_if(missing, [&](const StudyMeasure& each) { return possible.has(each); });
        return missing.empty();
    };
    if (!all_found_with(network))
        look_at_networks(study, all_found_with);
    if (!missing.empty())
        throw UserError(possible.why_unknown(missing.front()));
}

/// Makes and keeps a run, and notes how long the run took. Returns nothing if the run was interrupted.
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

/// Returns the figures of the first run that completes, from `index` forwards or backwards. Tries only a few runs.
std::optional<StudyFigures> StudySweep::figures_near(std::uint64_t index, bool forwards, Interruption& interruption) {
    constexpr int few = 3;
    std::uint64_t count = runs_.count();
    for (int tries = 0; tries < few && index < count && !interruption.requested(); forwards ? ++index : --index) {
        std::optional<StudyRun> run = runs_.at(index);
        if (!run)
            continue;
        ++tries;
        std::optional<StudyOutcome> outcome = results_.find(*run);
        if (!outcome && !(outcome = timed_outcome(*run, interruption)))
            return std::nullopt;
        if (outcome->ended == name_of(RunOutcome::completed))
            return outcome->figures;
    }
    return std::nullopt;
}

void StudySweep::try_measures(Interruption& interruption) {
    std::vector<StudyMeasure> missing(study_.measures.begin(), study_.measures.end());
    std::optional<StudyFigures> figures;
    for (bool forwards : {true, false}) {
        std::uint64_t from = forwards ? 0 : runs_.count() - 1;
        if (missing.empty() || interruption.requested())
            return;
        if (auto found = figures_near(from, forwards, interruption)) {
            figures = std::move(found);
            std::erase_if(missing, [&](const StudyMeasure& each) { return each.is_in(*figures); });
        }
    }
    if (figures && !missing.empty() && !interruption.requested())
        throw UserError(there_is_no_measure(missing.front(), *figures));
}

StudySweep::Missing StudySweep::missing() {
    std::uint64_t count = runs_.count(), found = 0;
    if (count > most_counted)
        return {count, false};
    for (std::uint64_t i = 0; i < count; ++i)
        if (std::optional<StudyRun> run = runs_.at(i); run && !results_.has(*run))
            ++found;
    return {found, true};
}

/// Measures the time of a run. A refused run takes no time, so further runs are tried, up to a limit.
std::optional<double> StudySweep::seconds_a_run(Interruption& interruption) {
    bool was_run = false;
    std::uint64_t refused = 0;
    for (std::uint64_t i = 0; !was_run && refused < most_read && i < runs_.count() && !interruption.requested(); ++i)
        if (std::optional<StudyRun> run = runs_.at(i))
            if (std::optional<StudyOutcome> outcome = timed_outcome(*run, interruption)) {
                was_run = outcome->refused.empty();
                refused += !was_run;
            }
    if (seconds_ && study_.seeds > 1 && !interruption.requested())
        time_another_seed(interruption);
    return seconds_;
}

/// Makes a run with another seed, because the first run of a combination may take longer than the others, which repeat
/// the first.
void StudySweep::time_another_seed(Interruption& interruption) {
    const double first = *seconds_, others = static_cast<double>(study_.seeds - 1);
    StudyRun another = *tried_;
    another.seed = another.seed == study_.first_seed ? another.seed + 1 : another.seed - 1;
    timed_outcome(another, interruption);
    seconds_ = (first + others * *seconds_) / (others + 1);
}

std::optional<StudyRun> StudySweep::next() {
    std::lock_guard lock(mutex_);
    for (std::uint64_t count = runs_.count(); next_ < count && !stop_;) {
        std::optional<StudyRun> run = runs_.at(next_++);
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
    const RunMaker make = maker_of(study_);
    while (!interruption.requested()) {
        std::optional<StudyRun> run = next();
        std::optional<StudyOutcome> outcome;
        if (!run || !(outcome = make(*run, interruption)))
            return;
        keep(*run, *outcome);
    }
}

void StudySweep::run(std::size_t workers, Interruption& interruption,
                     const std::function<void(std::uint64_t ended)>& show,
                     const std::function<bool(bool stopped)>& others) {
    trier_.reset();
    std::vector<Interruption> each(workers); // one for each worker, used by one run at a time
    auto stop = [&] {
        stop_ = true;
        std::ranges::for_each(each, &Interruption::request);
    };
    bool others_work = others != nullptr;
    auto attend = [&] {
        if (interruption.requested() || stop_)
            stop();
        on_exception(stop, [&] { show(ended_); });
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
