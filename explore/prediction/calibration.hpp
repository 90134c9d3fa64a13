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
/// REQUIRES: at least 6 values; with fewer, no interval has this probability.
MeasuredCost cost_of(std::vector<double> nanoseconds);

/// What a search costs on one thread.
struct ProblemCost {
    std::string problem;     ///< as in `problem = "..."`
    MeasuredCost error;      ///< an individual's error at a sample, or its objective
    MeasuredCost individual; ///< everything else of a generation, for each individual: mostly breeding
};

/// What messages cost in native runs.
struct MessageCosts {
    MeasuredCost switching;      ///< from a process to the next
    MeasuredCost there_and_back; ///< a message between processes of a thread or rank
    MeasuredCost across;         ///< ... between two threads or ranks that are awake
    MeasuredCost kilobyte;       ///< 1024 bytes of a message that a thread or rank takes over from another
};

/// What native runs cost on this computer.
struct Calibration {
    std::string processor; ///< the name of the host's processor
    std::string date;      ///< "2026-11-29"
    std::size_t repetitions = 0;
    MessageCosts threads;
    MeasuredCost across_asleep; ///< a message there and back between two threads that sleep
    MeasuredCost string;        ///< an individual in a task and its result, beyond the message
    std::vector<ProblemCost> problems;
    std::optional<MessageCosts> ranks; ///< set if they were measured
    MeasuredCost oversleeping;         ///< by how much a pause of a rank lasts longer than asked

    /// Returns whether threads or ranks that are awake take so long to answer that they fall asleep. Other programs
    /// then use the cores, and the costs predict nothing.
    bool is_disturbed() const;
};

struct CalibrationSettings {
    std::size_t repetitions = 15;                                                 ///< at least 6
    std::vector<std::string> problems;                                            ///< as in a netlist
    std::function<void(const std::string&)> progress = [](const std::string&) {}; ///< called with what is measured next
    /// Asked between measurements.
    std::function<bool()> is_interrupted = [] { return false; };
    /// Two ranks of mpirun, between which messages are measured, too; null: only threads are measured. REQUIRES: this
    /// is rank 0, and rank 1 calls help_to_measure().
    Ranks* ranks = nullptr;
};

/// Measures by native runs. Returns an empty list of problems if it was interrupted. Throws UserError for an unknown
/// problem.
Calibration measure_computer(const CalibrationSettings&);

/// Helps rank 0 to measure. Returns when it has measured.
void help_to_measure(Ranks&);

/// Returns a netlist include that describes the computer: a type `this_core` of nodes, a type `this_memory` through
/// which cores communicate, and vals for the costs of searches. If ranks were measured, also the types `this_rank` and
/// `this_network`.
std::string print_calibration(const Calibration&);

/// Cycles of `this_core` in a nanosecond.
inline constexpr double cycles_in_a_nanosecond = 10;

/// Returns the name of the val with the cost of a problem: "error_costly_work_100" for "costly(work = 100)".
std::string val_of_problem(const std::string& what, const std::string& problem);

} // namespace placedpar
