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

/// A netlist of the study: the first that can be read of some that are spread over it, or where its condition leaves
/// none of these of all. Throws UserError where none can: what the first is refused with.
Network readable_network(const Study&);

/// Throws UserError for one of these measures that no run can have: none of all combinations, or where there are very
/// many none of some that are spread over them. The network is one of the study's.
void require_possible(const std::vector<std::string>& measures, const Study&, const Network&);

/// Makes runs of a study, one after the other. What they have in common is made once: the kinds; what the
/// netlist's text says; the network of those of one combination, and where that does not depend on the seed what
/// happens on its machine (RepeatedRun); the records that are searched over, of those of one seed; the fitness of the
/// strings of own problems.
class StudyWorker {
public:
    /// REQUIRES: the study outlives it.
    explicit StudyWorker(const Study& study) : study_(study), netlist_(study.netlist, study.read) {}
    StudyWorker(const StudyWorker&) = delete; // the kinds know the problems
    StudyWorker& operator=(const StudyWorker&) = delete;

    /// None when it was interrupted.
    std::optional<StudyOutcome> outcome_of(const StudyRun&, Interruption&);
    /// How many of them it needed no machine for.
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
    ProblemRegistry problems_ = problems_of(seed_);      ///< of the seed
    std::map<std::uint64_t, ProblemRegistry> of_others_; ///< of seeds that have been, but not of very many
    const Catalogue kinds_ = known_kinds(problems_);
    std::optional<Overrides> set_; ///< of the network
    Network network_;
    std::optional<RecordedRun> record_; ///< of the network, if runs of it may be repeated
    std::uint64_t departed_ = 0;        ///< runs of the network that took another course
    std::uint64_t repeated_ = 0;
};

/// Makes the runs of a study that its results do not have yet. What comes of a run does not depend on when it is made
/// or beside which others, so neither do the results.
class StudySweep {
public:
    /// REQUIRES: both outlive it. Throws as Study::count().
    StudySweep(const Study& study, StudyResults& results) : study_(study), runs_(study), results_(results) {}

    /// Makes and keeps a run or two, unless they are there, so that a measure that no run has is refused before the
    /// others are made: UserError. None ends the others early.
    void try_measures(Interruption&);

    /// How many are missing; where there are very many at most that many.
    struct Missing {
        std::uint64_t runs = 0;
        bool exact = true;
    };
    Missing missing();
    /// How long a run takes in the mean, by the wall's clock; makes one of them where none was made, and one with
    /// another seed. None when interrupted. REQUIRES: called once.
    std::optional<double> seconds_a_run(Interruption&);

    /// Makes all that are missing, so many at once. `show` is told now and then how many have ended. `others`, if any,
    /// make some of them elsewhere: asked again and again, in the caller's thread, until it says that they have gone.
    void run(std::size_t workers, Interruption&, const std::function<void(std::uint64_t ended)>& show,
             const std::function<bool(bool stopped)>& others = nullptr);
    /// Returns the next run that another worker has to make. None when there is none left, or all is to stop.
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
    std::mutex mutex_; ///< of the results and what follows
    std::uint64_t next_ = 0;
    std::atomic<std::uint64_t> ended_ = 0;
    std::atomic<bool> stop_ = false;
    std::optional<StudyWorker> trier_; ///< of single runs, to see what they are like
    std::optional<StudyRun> tried_;    ///< the last of these
    std::optional<double> seconds_;    ///< that it took
};

} // namespace placedpar
