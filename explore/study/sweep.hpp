#pragma once

#include "explore/netlist_run.hpp"
#include "explore/problems.hpp"
#include "explore/study/remembered_problem.hpp"
#include "explore/study/results.hpp"
#include "explore/study/study.hpp"
#include "netlist/repeated_run.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Returns the first network of the study that can be read. Tries some combinations spread over the study. If the
/// study's condition holds for none of these, tries all combinations. If no network can be read, throws UserError with
/// the first refusal.
Network readable_network(const Study&);

/// Throws UserError for a measure that no run can have. Checks all combinations, or, if there are very many, some
/// combinations spread over the study. `network` is a network of the study.
void require_possible(const std::vector<std::string>& measures, const Study&, const Network&);

/// Makes runs of a study, one after the other, and keeps the data that they share. It makes the kinds of processes and
/// the parsed netlist once, a network once for each combination, and the simulated measurements once for each seed. If
/// the events on the machine do not depend on the seed, it simulates the machine only once for each combination
/// (RecordedRun). It computes a problem's objective once for each genome (RememberedProblem).
class StudyWorker {
public:
    /// REQUIRES: the study outlives this object.
    explicit StudyWorker(const Study& study) : study_(study), netlist_(study.netlist, study.read) {}
    StudyWorker(const StudyWorker&) =
        delete; // the kinds refer to problems_, so copies would refer to another object's problems
    StudyWorker& operator=(const StudyWorker&) = delete;

    /// Makes a run; returns nothing if it was interrupted.
    std::optional<StudyOutcome> outcome_of(const StudyRun&, Interruption&);
    /// Returns the number of runs that were repeated without simulating the machine.
    std::uint64_t repeated() const { return repeated_; }

private:
    ProblemRegistry problems_of(std::uint64_t seed);
    void go_to_seed(std::uint64_t seed);
    void go_to_network(const Overrides&);
    RunReport report_of(const StudyRun&, Interruption&);
    std::optional<RunReport> repeat(const RunSettings&);
    bool is_worth_recording() const;

    const Study& study_;
    const ParsedNetlist netlist_;
    std::uint64_t seed_ = 0;
    RememberedProblems remembered_;
    ProblemRegistry problems_ = problems_of(seed_);      ///< problems of seed_
    std::map<std::uint64_t, ProblemRegistry> of_others_; ///< problems of a limited number of earlier seeds
    const Catalogue kinds_ = known_kinds(problems_);
    std::optional<Overrides> set_; ///< settings of network_
    Network network_;
    /// Record of a run of the network, if further runs may be repeated from this record.
    std::optional<RecordedRun> record_;
    std::uint64_t departed_ = 0; ///< number of runs of the network that could not be repeated from the record
    std::uint64_t repeated_ = 0;
};

/// Makes the missing runs of a study. The outcome of a run depends neither on when it is made nor on other runs, so the
/// results do not depend on the order.
class StudySweep {
public:
    /// REQUIRES: both arguments outlive this object. Throws as Study::count() does.
    StudySweep(const Study& study, StudyResults& results) : study_(study), runs_(study), results_(results) {}

    /// Makes and keeps a few of the first and last runs, unless the results have them already. Throws UserError for a
    /// measure that these runs do not have, so that the error comes before the other runs are made.
    void try_measures(Interruption&);

    /// The number of missing runs; an upper bound if very many runs are missing.
    struct Missing {
        std::uint64_t runs = 0;
        bool exact = true;
    };
    Missing missing();
    /// Returns the mean wall-clock time of a run, in seconds. Makes a run, and a second run with another seed if there
    /// are several seeds. Returns nothing if interrupted. REQUIRES: called once.
    std::optional<double> seconds_a_run(Interruption&);

    /// Makes all missing runs in `workers` threads. `show` is called from time to time with the number of runs that
    /// have ended. `others`, if not null, lets other ranks of mpirun make some of the runs. It is called repeatedly, in
    /// the caller's thread, until it returns false.
    void run(std::size_t workers, Interruption&, const std::function<void(std::uint64_t ended)>& show,
             const std::function<bool(bool stopped)>& others = nullptr);
    /// Returns the next run for a worker to make; nothing if no run is left, or if the sweep must stop.
    std::optional<StudyRun> next();
    void keep(const StudyRun&, const StudyOutcome&);

private:
    void work(Interruption&);
    std::optional<StudyOutcome> timed_outcome(const StudyRun&, Interruption&);
    void time_another_seed(Interruption&);
    std::optional<StudyFigures> figures_near(std::uint64_t index, bool forwards, Interruption&);

    const Study& study_;
    const StudyRuns runs_;
    StudyResults& results_;
    std::mutex mutex_; ///< guards the results and the members below
    std::uint64_t next_ = 0;
    std::atomic<std::uint64_t> ended_ = 0;
    std::atomic<bool> stop_ = false;
    std::optional<StudyWorker> trier_; ///< makes single runs before the sweep, to measure how long they take
    std::optional<StudyRun> tried_;    ///< last run of trier_
    std::optional<double> seconds_;    ///< wall-clock duration of tried_, in seconds
};

} // namespace placedpar
