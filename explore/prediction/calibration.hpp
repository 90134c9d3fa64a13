#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

class Ranks; // ranks/ranks.hpp

/// The median of repeated measurements, in nanoseconds. `low` and `high` enclose the true median with a probability of
/// at least 95 %, for independent measurements (order statistics).
struct MeasuredCost {
    double median = 0, low = 0, high = 0;
};
/// Returns the median of the values and its interval. REQUIRES: at least 6 values; with fewer values, no interval has
/// the probability of 95 %.
MeasuredCost cost_of(std::vector<double> nanoseconds);

/// The cost of a search on one thread.
struct ProblemCost {
    std::string problem;     ///< as in `problem = "..."`
    MeasuredCost error;      ///< computing an individual's error at one sample, or its objective
    MeasuredCost individual; ///< the rest of a generation, mostly breeding, for each individual
};

/// The costs of messages in native runs.
struct MessageCosts {
    MeasuredCost switching;      ///< switch from one process to the next
    MeasuredCost there_and_back; ///< a message there and back between two processes of one thread or rank
    MeasuredCost across;         ///< a message there and back between two threads or ranks that are awake
    MeasuredCost kilobyte;       ///< 1024 bytes of a message between two threads or ranks
};

/// The costs of native runs on this computer.
struct Calibration {
    std::string processor; ///< the name of this computer's processor
    std::string date;      ///< "2026-11-29"
    std::size_t repetitions = 0;
    MessageCosts threads;
    MeasuredCost across_asleep; ///< a message there and back between two threads that sleep
    /// Packing and unpacking an individual in a task and in the result, without the message itself.
    MeasuredCost string;
    std::vector<ProblemCost> problems;
    std::optional<MessageCosts> ranks; ///< set if ranks were measured
    MeasuredCost oversleeping;         ///< how much longer a pause of a rank lasts than requested

    /// Returns whether threads or ranks that are awake take so long to answer that they fall asleep. This happens if
    /// other programs use the cores; the costs then predict nothing.
    bool is_disturbed() const;
};

struct CalibrationSettings {
    std::size_t repetitions = 15;      ///< at least 6
    std::vector<std::string> problems; ///< as in a netlist
    std::function<void(const std::string&)> progress = [](const std::string&) {
    }; ///< called with the name of the next measurement
    /// Called between measurements; the measurement ends if it returns true.
    std::function<bool()> is_interrupted = [] { return false; };
    /// Two ranks of mpirun, between which messages are measured, too; null: only threads are measured. REQUIRES: this
    /// is rank 0, and rank 1 calls help_to_measure().
    Ranks* ranks = nullptr;
};

/// Measures the costs by native runs. If it is interrupted, the result has no problems. Throws UserError for an unknown
/// problem.
Calibration measure_computer(const CalibrationSettings&);

/// Takes part in the measurements of rank 0. Returns when rank 0 has finished.
void help_to_measure(Ranks&);

/// Returns the text of a file that netlists can include. The file describes the computer: a type `this_core` of nodes,
/// a type `this_memory` through which cores communicate, and constants (`val`) for the costs of searches. If ranks were
/// measured, also the types `this_rank` and `this_network`.
std::string print_calibration(const Calibration&);

/// Cycles of `this_core` in a nanosecond.
inline constexpr double cycles_in_a_nanosecond = 10;

/// Returns the name of the constant (`val`) that holds the cost of a problem, such as "error_costly_work_100" for the
/// problem "costly(work = 100)".
std::string val_of_problem(const std::string& what, const std::string& problem);

} // namespace placedpar
