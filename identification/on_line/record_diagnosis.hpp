#pragma once

#include "hydraulics/data/record.hpp"
#include "identification/flag.hpp"
#include "identification/on_line/diagnosis.hpp"
#include "identification/on_line/record_samples.hpp"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace placedpar::identification {

/// What least squares over all of a movement, rest included, finds of a link at once: what a verdict rests on.
struct WholeMovement {
    Deviation deviation; ///< from the link's compliance in health, no leak, no offset
    WayUnits units;
    double compliance_in3_per_psi;
};

/// What a movement of a record tells of one link: where its estimate settled, or else where it stood last.
struct LinkFinding {
    hydraulics::Link link;
    std::optional<double> compliance_in3_per_psi; ///< none: the pressure never moved enough
    double standard_error_in3_per_psi = 0;        ///< of least squares on the window of the estimate
    std::pair<double, double> spread_in3_per_psi; ///< the least and the greatest of the last generations' best
    std::vector<Flag> flags;                      ///< empty: nothing unusual
    std::optional<WholeMovement> whole = {};      ///< none: too few samples
};

/// From the valves' opening to their closing, or to a gap of the record, or 4 s of it: see Movement.
struct MovementFinding {
    hydraulics::LinkSet set; ///< that moved together
    double from_s, to_s;     ///< of the record
    std::vector<LinkFinding> links;
};

/// A machine's record, diagnosed as the service does it while the machine works: the same samples give the same
/// estimates and verdicts, to the bit, where seed and name are the same. Records of any length may be given in pieces.
class RecordDiagnosis {
public:
    RecordDiagnosis(Diagnosis diagnosis, const DiagnosisSettings& settings,
                    const hydraulics::PerLink<LinkReader>& readers)
        : diagnosis_(std::move(diagnosis)), settings_(settings), readers_(readers) {}

    /// The next piece of the record; gives the movements that end in it. REQUIRES: the configuration has been told; the
    /// piece has the active links' readings. Throws RefusedSample where it is not later than the one before.
    std::vector<MovementFinding> take(const hydraulics::Record& piece);
    /// The record ends: the movements that have not.
    std::vector<MovementFinding> end();

    const Diagnosis& diagnosis() const { return diagnosis_; }

private:
    struct Progress {
        bool moves = false;
        double from_s = 0, to_s = 0;
    };

    void follow(const SampleOutcome& outcome, std::vector<MovementFinding>& found);
    MovementFinding finding(hydraulics::LinkSet set, const Progress& progress, const SampleOutcome& outcome) const;

    Diagnosis diagnosis_;
    DiagnosisSettings settings_;
    hydraulics::PerLink<LinkReader> readers_;
    std::map<hydraulics::LinkSet, Progress> progress_;
};

} // namespace placedpar::identification
