#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

class Ranks; // ranks/ranks.hpp

/// The median of repeated measurements, in nanoseconds. If the measurements are independent, `low` and `high` enclose
/// the true median with a probability of at least 95 % (by order statistics).
struct MeasuredCost {
    double median = 0, low = 0, high = 0;
};
/// Returns the median of the values and its interval. REQUIRES: at least 6 values; with fewer values, no interval has
/// the probability of 95 %.
MeasuredCost cost_of(std::vector<double> nanoseconds);

/// The cost of a search on one thread.
struct ProblemCost {
    std::string problem; ///< as in `problem = "..."`
    MeasuredCost error;  ///< time for an individual's error at one sample of measurements, or for its objective
    /// Time for the rest of a generation, mostly breeding, divided by the number of individuals.
    MeasuredCost individual;
};

/// The costs of messages in native runs, that is, runs of a netlist's processes on this computer without simulating a
/// machine.
struct MessageCosts {
    MeasuredCost switching;      ///< switch from one process to the next
    MeasuredCost there_and_back; ///< a message there and back between two processes of one thread or rank
    MeasuredCost across;         ///< a message there and back between two threads or ranks that are awake
    MeasuredCost kilobyte;       ///< 1024 bytes of a message between two threads or ranks
};

/// The costs of native runs on this computer, from which the times of such runs are predicted.
struct Calibration {
    std::string processor; ///< the name of this computer's processor
    std::string date;      ///< "2026-11-29"
    std::size_t repetitions = 0;
    MessageCosts threads;
    MeasuredCost across_asleep; ///< a message there and back between two threads that sleep
    /// Packing and unpacking an individual in the messages to and from a slave, without sending these messages.
    MeasuredCost string;
    std::vector<ProblemCost> problems;
    std::optional<MessageCosts> ranks; ///< set if the messages between ranks of mpirun were measured
    MeasuredCost oversleeping;         ///< how much longer than requested a pause of a rank lasts

    /// Returns whether the costs predict nothing, because threads or ranks took so long to answer that they fell
    /// asleep. This happens if other programs use the cores.
    bool is_disturbed() const;
};

struct CalibrationSettings {
    std::size_t repetitions = 15;      ///< at least 6
    std::vector<std::string> problems; ///< as in a netlist
    std::function<void(const std::string&)> progress = [](const std::string&) {
    }; ///< called with the name of the next measurement
    /// Called between measurements; the measurement ends if it returns true.
    std::function<bool()> is_interrupted = [] { return false; };
    /// Two ranks of mpirun, whose messages are also measured; null: only threads are measured. REQUIRES: this is rank
    /// 0, and rank 1 calls help_to_measure().
    Ranks* ranks = nullptr;
};

/// Measures the costs by native runs. If it is interrupted, the result has no problems. Throws UserError for an unknown
/// problem.
Calibration measure_computer(const CalibrationSettings&);

/// Takes part in the measurements of rank 0 as the other end of its messages. Returns when rank 0 has finished.
void help_to_measure(Ranks&);

/// Returns the text of a file that netlists can include to describe this computer. The file has a type `this_core` of
/// nodes, a type `this_memory` through which cores communicate, and constants (`val`) for the costs of searches. If
/// ranks were measured, it also has the types `this_rank` and `this_network`.
std::string print_calibration(const Calibration&);

/// The clock of `this_core`, in cycles per nanosecond.
inline constexpr double cycles_in_a_nanosecond = 10;

/// Returns the name of the constant (`val`) that holds the cost of a problem, such as "error_costly_work_100" for the
/// problem "costly(work = 100)".
std::string val_of_problem(const std::string& what, const std::string& problem);

} // namespace placedpar
