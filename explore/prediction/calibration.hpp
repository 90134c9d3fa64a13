#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace placedpar {

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

/// What native runs cost on this computer.
struct Calibration {
    std::string processor; ///< the name of the host's processor
    std::string date;      ///< "2026-11-29"
    std::size_t repetitions = 0;
    MeasuredCost switching;             ///< from a process to the next
    MeasuredCost there_and_back;        ///< a message between processes of a thread
    MeasuredCost across, across_asleep; ///< between threads: both awake; both asleep
    MeasuredCost kilobyte;              ///< 1024 bytes of a message that a thread takes over from another
    MeasuredCost string;                ///< an individual in a task and its result, beyond the message
    std::vector<ProblemCost> problems;

    /// Returns whether threads that are awake take so long to answer that they fall asleep. Other programs then use the
    /// cores, and the costs predict nothing.
    bool is_disturbed() const;
};

struct CalibrationSettings {
    std::size_t repetitions = 15;                                                 ///< at least 6
    std::vector<std::string> problems;                                            ///< as in a netlist
    std::function<void(const std::string&)> progress = [](const std::string&) {}; ///< called with what is measured next
    /// Asked between measurements.
    std::function<bool()> is_interrupted = [] { return false; };
};

/// Measures by native runs. Returns an empty list of problems if it was interrupted. Throws UserError for an unknown
/// problem.
Calibration measure_computer(const CalibrationSettings&);

/// Returns a netlist include that describes the computer: a type `this_core` of nodes, a type `this_memory` through
/// which cores communicate, and vals for the costs of searches.
std::string print_calibration(const Calibration&);

/// Cycles of `this_core` in a nanosecond.
inline constexpr double cycles_in_a_nanosecond = 10;

/// Returns the name of the val with the cost of a problem: "error_costly_work_100" for "costly(work = 100)".
std::string val_of_problem(const std::string& what, const std::string& problem);

} // namespace placedpar
