#pragma once

#include "experiments/kit/experiment.hpp"
#include "hydraulics/circuit/link_calibration.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// One of the two experiments of section 4.3, which differ in the readings from which the valve's areas are computed.
struct ParallelExperiment {
    const char *plot, *title; ///< file name and heading of the plot
    hydraulics::AreasFrom from;
};

/// Identifies the boom's compliance from chapter 3's records, for every seed of the replay: by the parallel algorithm
/// on the sixteen transputers of Figure E.2, and by the traditional algorithm on one transputer. Judges the thesis's
/// "the parameter convergence rate and the estimated C_BOi from PGA are almost identical to that from traditional GA"
/// (4.3).
Replay replay_parallel_identification(const ReplayContext& context, const ParallelExperiment& experiment);

/// The result of one algorithm in one record.
struct FoundInRecord {
    double compliance_in3_per_psi;
    double generations; ///< first generation from which every answer is within 10 % of the true compliance; greater
                        ///< than the number of generations if there is no such generation
    double seconds;     ///< simulated time of the last answer
};

/// The results of the traditional algorithm and of a parallel algorithm. Each vector has one result for each record.
struct BothFound {
    double true_in3_per_psi;
    std::vector<FoundInRecord> traditional, parallel;
};

/// Returns three mean differences over the records, parallel minus traditional, each with its 95 % interval. The first
/// is the difference of the percentages of records in which the last answer is within 10 % of the true compliance; it
/// must be at least -5. The second is the difference of the compliances; its size must be at most 2 % of the true
/// value. The third is the difference of the numbers of generations until the compliance stays within 10 %; it must be
/// at most 5 (one sample). A bound is missed if the whole interval is beyond it. REQUIRES: both algorithms have the
/// same number of results, at least two.
std::vector<Cell> cells_of_difference(const BothFound& found, const std::string& column);

} // namespace placedpar
