#pragma once

#include "experiments/kit/experiment.hpp"
#include "hydraulics/circuit/link_calibration.hpp"

#include <string>
#include <vector>

namespace placedpar {

/// One of the two experiments of section 4.3.
struct ParallelExperiment {
    const char *plot, *title; ///< name of its file, and heading
    hydraulics::AreasFrom from;
};

/// Identifies the boom of chapter 3's records on the sixteen transputers of Figure E.2, and by the traditional
/// algorithm on one of them, for as many seeds as the context says. Judges the thesis's "the parameter convergence rate
/// and the estimated C_BOi from PGA are almost identical to that from traditional GA" (4.3).
Replay replay_parallel_identification(const ReplayContext& context, const ParallelExperiment& experiment);

/// What one way of searching found in one record.
struct FoundInRecord {
    double compliance_in3_per_psi;
    double generations; ///< from which on every answer is within 10 % of the true compliance; beyond the last: never
    double seconds;     ///< of the machine, from the first sample to the last answer
};

/// The results of the traditional algorithm and of a parallel one, by record.
struct BothFound {
    double true_in3_per_psi;
    std::vector<FoundInRecord> traditional, parallel;
};

/// Returns the cells of the difference between them, parallel less traditional, with the 95 % interval of its mean over
/// the records: share of records within 10 % of the true compliance (bound: 5 points fewer), compliance (bounds: 2 % of
/// the true one either way) and generations until it stays within 10 % (bound: 5 more, which are one sample). A bound
/// is missed if the whole interval misses it. REQUIRES: as many results of both, at least two.
std::vector<Cell> cells_of_difference(const BothFound& found, const std::string& column);

} // namespace placedpar
