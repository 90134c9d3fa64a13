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

/// The result of a least-squares fit to a whole movement, including the rest before and after it, for one link. The
/// verdict on the link follows from such results.
struct WholeMovement {
    Deviation deviation; ///< deviation from a healthy link, which has the healthy compliance, no leak and no offset
    WayUnits units;
    double compliance_in3_per_psi;
};

/// The result of a movement for one link: the settled estimate, in which many generations agree, or the last estimate
/// if none has settled.
struct LinkFinding {
    hydraulics::Link link;
    /// The compliance is nullopt if the pressure never changed fast enough to determine it.
    std::optional<double> compliance_in3_per_psi;
    double standard_error_in3_per_psi = 0; ///< by least squares over the samples of the estimate
    /// The least and the greatest compliance of the last generations' best individuals.
    std::pair<double, double> spread_in3_per_psi;
    std::vector<Flag> flags;                 ///< empty if nothing is unusual
    std::optional<WholeMovement> whole = {}; ///< nullopt: too few samples
};

/// The results of one movement. A movement lasts from the opening of the valves to their closing, to a gap in the
/// record, or for 4 s (see Movement).
struct MovementFinding {
    hydraulics::LinkSet set; ///< the links that moved together
    double from_s, to_s;     ///< times in the record
    std::vector<LinkFinding> links;
};

/// Diagnoses a record as the monitor, a service that runs all the time, diagnoses a working machine. From equal
/// samples, seed and name, this class and the monitor compute equal estimates and verdicts, bit by bit. A long record
/// may come in pieces.
class RecordDiagnosis {
public:
    RecordDiagnosis(Diagnosis diagnosis, const DiagnosisSettings& settings,
                    const hydraulics::PerLink<LinkReader>& readers)
        : diagnosis_(std::move(diagnosis)), settings_(settings), readers_(readers) {}

    /// Processes the next piece of the record and returns the movements that end in it. REQUIRES: the diagnosis has a
    /// configuration, and the piece has the readings of the active links. Throws RefusedSample if the piece is not
    /// later than the previous piece.
    std::vector<MovementFinding> take(const hydraulics::Record& piece);
    /// Ends the record and returns the movements that were still going on.
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
