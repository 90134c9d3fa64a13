#include "workbench/study/sweep.hpp"

#include "text/user_error.hpp"
#include "workbench/load.hpp"
#include "workbench/problems.hpp"
#include "workbench/workers.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

namespace placedpar {

namespace {

constexpr std::uint64_t most_read = 100;          ///< netlists that are looked at before a study is refused
constexpr std::uint64_t most_counted = 1'000'000; ///< runs that are looked up one by one

Network network_of(const Study& study, const Overrides& set) {
    return load_network(
        study.netlist, set, known_problems(0), [](const std::string&) {}, study.read);
}

/// The network of the run before is kept: those of one combination come one after the other.
class LastNetwork {
public:
    const Network& of(const Study& study, const Overrides& set) {
        if (!set_ || *set_ != set) {
            set_.reset();
            network_ = network_of(study, set);
            set_ = set;
        }
        return network_;
    }

private:
    std::optional<Overrides> set_;
    Network network_;
};

/// None when it was interrupted.
std::optional<StudyOutcome> outcome_of(const Study& study, const StudyRun& run, LastNetwork& last,
                                       Interruption& interruption) {
    try {
        const Network& network = last.of(study, run.set);
        RunReport report = run_netlist(network, known_problems(run.seed),
                                       {.seed = run.seed, .until = study.until, .interruption = &interruption});
        if (report.result.ending == Ending::interrupted)
            return std::nullopt;
        return StudyOutcome{.ended = name_of(report.result.ending),
                            .time = report.result.time,
                            .fingerprint = report.result.fingerprint,
                            .netlist_hash = network.hash,
                            .figures = figures_of(report, network)};
    } catch (const UserError& refused) {
        return StudyOutcome{.ended = "refused", .refused = refused.what()};
    }
}

} // namespace

Network readable_network(const Study& study) {
    std::exception_ptr first;
    std::uint64_t count = study.count(), step = std::max<std::uint64_t>(count / most_read, 1);
    for (std::uint64_t i = 0; i < count; i += step) {
        std::optional<StudyRun> run = study.at(i);
        if (!run)
            continue;
        try {
            return network_of(study, run->set);
        } catch (const UserError&) {
            if (!first)
                first = std::current_exception();
        }
        if (count - i <= step)
            break;
    }
    if (first)
        std::rethrow_exception(first);
    throw UserError("the study's condition leaves nothing to be run");
}

/// Makes it, keeps it, and notes how long it took. None when it was interrupted.
std::optional<StudyOutcome> StudySweep::timed_outcome(const StudyRun& run, Interruption& interruption) {
    LastNetwork last;
    auto begun = std::chrono::steady_clock::now();
    std::optional<StudyOutcome> outcome = outcome_of(study_, run, last, interruption);
    if (outcome) {
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
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
    return seconds_;
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

void StudySweep::work(Interruption& interruption) {
    LastNetwork last;
    try {
        while (!interruption.requested()) {
            std::optional<StudyRun> run = next();
            std::optional<StudyOutcome> outcome;
            if (!run || !(outcome = outcome_of(study_, *run, last, interruption)))
                return;
            std::lock_guard lock(mutex_);
            results_.keep(*run, *outcome);
            ++ended_;
        }
    } catch (...) {
        stop_ = true;
        throw;
    }
}

void StudySweep::run(std::size_t workers, Interruption& interruption,
                     const std::function<void(std::uint64_t ended)>& show) {
    std::vector<Interruption> each(workers); // of one run at a time
    on_workers(
        workers, [&](std::size_t worker) { work(each[worker]); },
        [&] {
            if (interruption.requested())
                stop_ = true;
            if (stop_)
                for (Interruption& one : each)
                    one.request();
            show(ended_);
        });
}

} // namespace placedpar
