#pragma once

#include "explore/study/rank_messages.hpp"
#include "explore/study/ranks.hpp"
#include "explore/study/sweep.hpp"

#include <cstddef>
#include <cstdint>
#include <set>

namespace placedpar {

/// What rank 0 has the others do. It alone has the results; the others make runs for it (rank_helper.hpp). When it is
/// destroyed they have gone, whatever was thrown meanwhile.
class RankZero {
public:
    /// REQUIRES: ranks outlives it.
    explicit RankZero(Ranks&);
    ~RankZero();
    RankZero(const RankZero&) = delete;
    RankZero& operator=(const RankZero&) = delete;

    /// Has the others begin. REQUIRES: the sweep is of the source, and outlives this.
    void begin(StudySweep& sweep, const StudySource&);
    /// Does what they ask for, and keeps what came of their runs; `stopped` has them end these early. False when all
    /// have gone. Throws UserError where one of them cannot go on, or the results cannot be kept. REQUIRES: begin() was
    /// called.
    bool serve(bool stopped);
    /// Runs that others were handed and that none has ended: once serve() is false, of those who left them.
    std::uint64_t in_hand() const { return in_hand_; }
    /// With this one.
    std::size_t ranks() const { return static_cast<std::size_t>(ranks_.count()); }

private:
    void stop();
    void take(const RankMessage&, int from);
    void hand_out(int to);
    void tell_all(const RankMessage&);

    Ranks& ranks_;
    StudySweep* sweep_ = nullptr;
    std::set<int> helping_; ///< that have not gone
    std::uint64_t in_hand_ = 0;
    bool stopped_ = false;
};

} // namespace placedpar
