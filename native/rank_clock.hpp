#pragma once

#include "netlist/run_report.hpp"
#include "runtime/time.hpp"

#include <chrono>
#include <cstddef>
#include <vector>

namespace placedpar {

class Ranks; // ranks/ranks.hpp

namespace native {

/// A reading of a computer's steady clock. The clocks of two computers do not agree.
using Reading = std::chrono::nanoseconds;

Reading read_clock();

/// The clock of a rank, compared with the clock of rank 0. A rank is a copy of the program, started by mpirun, maybe on
/// another computer.
struct ComparedClock {
    Reading at{};    ///< time of the comparison, by rank 0's clock
    Reading ahead{}; ///< how far the rank's clock is ahead of rank 0's clock
    Reading error{}; ///< upper bound for the error of `ahead`
};

/// Compares the clocks of all ranks with the clock of rank 0. Rank 0 asks each rank for its clock many times, and uses
/// the answer that came in the shortest time. The clock was read at some moment between question and answer, so the
/// error is at most half the time between them: F. Cristian, Probabilistic clock synchronization, Distributed Computing
/// 3 (1989), pages 146-158. All ranks return at nearly the same time. Returns the clocks by rank in rank 0, and nothing
/// in the other ranks. REQUIRES: called in all ranks; the ranks send each other no other texts meanwhile.
std::vector<ComparedClock> compare_clocks(Ranks&);

/// Converts the times of all ranks to the clock of rank 0, so that one trace can show events of all ranks. The common
/// time counts from the moment at which the first rank began. The clocks were compared before and after the run, and
/// each is assumed to drift evenly in between.
class CommonClock {
public:
    /// `begun`: when each rank began, by its own clock.
    CommonClock(std::vector<ComparedClock> before, std::vector<ComparedClock> after, std::vector<Reading> begun);

    /// Returns the common time. `since_begun`: time since the rank began, by its own clock.
    Time convert(std::size_t rank, Time since_begun) const;
    /// Returns offset, drift and error of the clocks of the ranks above 0, for reports.
    std::vector<RankClock> clocks() const;

private:
    Reading begun_by_rank_zero(std::size_t rank) const { return begun_[rank] - before_[rank].ahead; }

    std::vector<ComparedClock> before_, after_; ///< clocks before and after the run
    std::vector<Reading> begun_;
    Reading first_begun_;
};

} // namespace native

} // namespace placedpar
