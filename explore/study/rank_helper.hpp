#pragma once

#include "explore/study/rank_messages.hpp"
#include "explore/study/sweep.hpp"
#include "ranks/ranks.hpp"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Makes runs of a sweep (all runs of a study) in a rank of mpirun other than 0. Rank 0 hands out the runs
/// (rank_zero.hpp). The helper makes runs in `jobs` threads. It requests one run more than it has threads, so that no
/// thread waits for rank 0.
class RankHelper {
public:
    /// REQUIRES: `ranks` outlives this object.
    RankHelper(Ranks& ranks, std::size_t jobs) : ranks_(ranks), jobs_(jobs), interruptions_(jobs) {}

    /// Makes runs until none is left, or until the interruption. Reports errors to rank 0. Calls `study` only after
    /// rank 0 has begun a sweep.
    void help(const std::function<Study()>& study, const Interruption&);

private:
    RankMessage wait_for_message();
    void make_runs(const Study&, const Interruption&);
    void work(const Study&, std::size_t worker);
    std::optional<StudyRun> wait_for_run();
    void exchange_messages();
    void take(const RankMessage&);
    void stop();
    void tell(const RankMessage&);

    Ranks& ranks_;
    std::size_t jobs_;
    std::string digest_; ///< digest of rank 0's source
    /// Number of requests that rank 0 has not answered; after the message `stop`, rank 0 answers no request.
    std::size_t unanswered_ = 0;
    std::mutex mutex_; ///< guards the members below
    std::condition_variable changed_;
    std::deque<StudyRun> runs_;      ///< runs to be made
    std::vector<RankMessage> ended_; ///< messages about ended runs, to be sent
    bool no_more_ = false;           ///< rank 0 has no runs left to hand out
    bool stopped_ = false;
    std::vector<Interruption> interruptions_; ///< one for each worker, used by one run at a time
};

} // namespace placedpar
