#pragma once

#include "explore/study/rank_messages.hpp"
#include "explore/study/sweep.hpp"
#include "ranks/ranks.hpp"

#include <cstddef>
#include <cstdint>
#include <set>

namespace placedpar {

/// Distributes the runs of a study from rank 0 of mpirun to the other ranks (rank_helper.hpp). Only rank 0 has the
/// results. The destructor waits until all other ranks have stopped helping, even after an exception.
class RankZero {
public:
    /// REQUIRES: the ranks outlive this object.
    explicit RankZero(Ranks&);
    ~RankZero();
    RankZero(const RankZero&) = delete;
    RankZero& operator=(const RankZero&) = delete;

    /// Tells the other ranks to begin. REQUIRES: the sweep makes runs of this source, and outlives this object.
    void begin(StudySweep& sweep, const StudySource&);
    /// Answers the requests of the other ranks and keeps the outcomes of their runs; `stopped` ends these runs early.
    /// Call it repeatedly, until it returns false because all other ranks have ended. Throws UserError if a rank fails,
    /// or if an outcome cannot be stored. REQUIRES: begin() was called.
    bool serve(bool stopped);
    /// Returns the number of runs that were handed out and have not ended. After serve() has returned false, these runs
    /// are left unfinished.
    std::uint64_t in_hand() const { return in_hand_; }
    /// Returns the number of ranks, including rank 0.
    std::size_t ranks() const { return static_cast<std::size_t>(ranks_.count()); }

private:
    void stop();
    void take(const RankMessage&, int from);
    void hand_out(int to);
    void tell_all(const RankMessage&);

    Ranks& ranks_;
    StudySweep* sweep_ = nullptr;
    std::set<int> helping_; ///< ranks that are still helping
    std::uint64_t in_hand_ = 0;
    bool stopped_ = false;
};

} // namespace placedpar
