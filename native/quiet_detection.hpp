#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace placedpar::native {

/// The answer of a rank that has nothing to do to a question of rank 0. A rank is a copy of the program, started by
/// mpirun, that runs some of the processes.
struct QuietAnswer {
    std::uint64_t sent = 0, received = 0; ///< numbers of messages that can give a rank something to do
    bool awaits_end = false;              ///< processes of the rank wait for the end of the work
};

/// Finds out for rank 0 when no rank has anything to do and no message is under way, so that the run can end.
///
/// The method is F. Mattern's method of four counters (Algorithms for distributed termination detection, Distributed
/// Computing 2, 1987, pages 161-175). Rank 0 asks all ranks in rounds. A rank answers when it has nothing to do.
/// Suppose that the number of messages received, summed in one round, equals the number sent, summed in the next round.
/// Then between the rounds all ranks had nothing to do, and no message was under way.
class QuietDetection {
public:
    explicit QuietDetection(std::size_t ranks) : answers_(ranks) {}

    enum class Verdict {
        unknown, ///< answers are missing
        again,   ///< another round is needed
        quiet,   ///< no rank has anything to do
        over     ///< no rank has anything to do, and no process waits for the end of the work
    };
    /// Returns whether answers of the current round are missing.
    bool is_asking() const { return missing_ > 0; }
    /// Begins a round. REQUIRES: !is_asking().
    void ask() { missing_ = answers_.size(); }
    /// REQUIRES: a round has begun, and the rank has not answered in it.
    Verdict take(std::size_t rank, const QuietAnswer&);

private:
    Verdict compare();

    std::vector<QuietAnswer> answers_;
    std::size_t missing_ = 0;
    std::optional<std::uint64_t> received_before_; ///< number of messages received, as counted in the previous round
};

} // namespace placedpar::native
