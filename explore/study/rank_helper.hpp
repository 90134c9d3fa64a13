#pragma once

#include "explore/study/rank_messages.hpp"
#include "explore/study/ranks.hpp"
#include "explore/study/sweep.hpp"

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// What a rank other than 0 does for a sweep: it makes the runs that rank 0 hands it (rank_zero.hpp), so many at once,
/// and has one more in hand, so that it never waits for the next.
class RankHelper {
public:
    /// REQUIRES: ranks outlives it.
    RankHelper(Ranks& ranks, std::size_t jobs) : ranks_(ranks), jobs_(jobs), interruptions_(jobs) {}

    /// Returns when there is nothing left to do. What goes wrong is told to rank 0. `study` is called when there is
    /// something to do. The interruption ends it early.
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
    std::string digest_;         ///< of what rank 0 sweeps
    std::size_t unanswered_ = 0; ///< requests, which rank 0 answers unless it stops all
    std::mutex mutex_;           ///< of what follows
    std::condition_variable changed_;
    std::deque<StudyRun> runs_;      ///< to be made
    std::vector<RankMessage> ended_; ///< to be told
    bool no_more_ = false;           ///< rank 0 has none left
    bool stopped_ = false;
    std::vector<Interruption> interruptions_; ///< of one run at a time each
};

} // namespace placedpar
