#pragma once

#include "workbench/netlist_run.hpp"
#include "workbench/problems.hpp"
#include "workbench/study/results.hpp"
#include "workbench/study/study.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// A netlist of the study: the first of some that are spread over it, or where its condition leaves none of these the
/// first of all, that can be read. Throws UserError where none can: what the first is refused with.
Network readable_network(const Study&);

/// Throws UserError for one of these measures that no run can have: none of all combinations, or where there are very
/// many none of some that are drawn. The network is one of the study's.
void require_possible(const std::vector<std::string>& measures, const Study&, const Network&);

/// Makes runs of a study, one after the other. What they have in common is made once: the network of those of one
/// combination; the kinds, and the records that are searched over, of those of one seed.
class StudyWorker {
public:
    /// REQUIRES: the study outlives it.
    explicit StudyWorker(const Study& study) : study_(study) {}

    /// None when it was interrupted.
    std::optional<StudyOutcome> outcome_of(const StudyRun&, Interruption&);

private:
    /// What a seed decides. The kinds know the problems.
    struct Seeded {
        explicit Seeded(std::uint64_t seed) : problems(known_problems(seed)), kinds(known_kinds(problems)) {}
        ProblemRegistry problems;
        Catalogue kinds;
    };
    const Seeded& seeded(std::uint64_t seed);
    const Network& network_of(const Overrides&);

    const Study& study_;
    std::map<std::uint64_t, Seeded> seeded_; ///< by seed: not of very many
    std::optional<Overrides> set_;           ///< of the network
    Network network_;
};

/// Makes the runs of a study that its results do not have yet. What comes of a run does not depend on when it is made
/// or beside which others, so neither do the results.
class StudySweep {
public:
    /// REQUIRES: both outlive it.
    StudySweep(const Study& study, StudyResults& results) : study_(study), results_(results) {}

    /// Makes and keeps a run or two, unless they are there, so that a measure that no run has is refused before the
    /// others are made: UserError. None ends the others early.
    void try_measures(Interruption&);

    /// How many are missing; where there are very many at most that many.
    struct Missing {
        std::uint64_t runs = 0;
        bool exact = true;
    };
    Missing missing();
    /// How long a run takes, by the wall's clock; makes one of them where none was made. None when interrupted.
    std::optional<double> seconds_a_run(Interruption&);

    /// Makes all that are missing, so many at once. `show` is told now and then how many have ended. `others`, if any,
    /// make some of them elsewhere: asked again and again, in the caller's thread, until it says that they have gone.
    void run(std::size_t workers, Interruption&, const std::function<void(std::uint64_t ended)>& show,
             const std::function<bool(bool stopped)>& others = nullptr);
    /// For the others: the next run that somebody has to make. None when there is none left, or all is to stop.
    std::optional<StudyRun> next();
    void keep(const StudyRun&, const StudyOutcome&);

private:
    void work(Interruption&);
    std::optional<StudyOutcome> timed_outcome(const StudyRun&, Interruption&);
    std::optional<StudyFigures> figures_near(std::uint64_t index, bool forwards, Interruption&);

    const Study& study_;
    StudyResults& results_;
    std::mutex mutex_; ///< of the results and what follows
    std::uint64_t next_ = 0;
    std::atomic<std::uint64_t> ended_ = 0;
    std::atomic<bool> stop_ = false;
    std::optional<double> seconds_;
};

} // namespace placedpar
