#pragma once

#include "explore/study/results.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// Statistics of a measure over the runs of one combination of settings.
struct StudyCell {
    std::uint64_t runs = 0;
    double mean = 0, least = 0, greatest = 0;
    double half_width = 0; ///< half of the width of Student's 95 % confidence interval of the mean; 0 for a single run

    void add(double value);
    /// Computes half_width. REQUIRES: add() is not called afterwards.
    void close();

private:
    double squares_ = 0; ///< sum of the squared distances from the mean (B. Welford, 1962)
};

/// One run of a combination.
struct StudiedRun {
    std::uint64_t seed = 0;
    std::string ended = "";
    std::vector<std::optional<double>> figures = {}; ///< one for each measure; nothing if the run does not have it
};

/// The runs of one combination.
struct StudyLine {
    std::vector<std::string> values; ///< values of the axes; "" for an axis that this combination does not set
    std::uint64_t runs = 0;          ///< number of all runs
    std::map<std::string, std::uint64_t> ended;        ///< number of runs that did not complete, by how they ended
    std::map<std::string, std::uint64_t> without = {}; ///< number of completed runs that measured no number, by measure
    std::string refused = "";                          ///< first line of the reason for a refusal
    std::vector<StudyCell> cells;                      ///< one for each measure
    std::vector<StudiedRun> each = {};                 ///< all runs, by seed
};

/// The statistics of a study's runs.
struct StudySummary {
    std::string netlist, version;
    std::vector<std::string> axes = {}; ///< axes that have several values
    Overrides fixed = {};               ///< settings that are equal in all combinations
    /// Each figure is divided by the figure of the run with these settings; empty: figures are absolute.
    Overrides relative_to = {};
    std::uint64_t unrelated = 0; ///< number of runs with figures for which that run is missing or ended differently
    std::vector<std::string> measures = {}, units = {};
    std::vector<StudyLine> lines = {}; ///< sorted by the values; numbers are sorted by size

    std::uint64_t runs() const;
    /// Returns the names of all settings of the runs.
    std::vector<std::string> names() const;
    /// Returns whether some line has all of these settings.
    bool has_some(const Overrides&) const;
};

/// Summarises the runs in the results, or, with a study, only the runs of its combinations, with any seed. If
/// `measures` is empty, the measures requested last are used. With `relative_to`, each figure is divided by the figure
/// of a reference run. The reference run has the seed of the run and its settings, except for the settings in
/// `relative_to`. A run has no figures if its reference run is missing or ended differently. Values with the same
/// meaning, such as 8 and 8.0, count as one value, spelt as in the study (SettingValue).
StudySummary summary_of(StudyResults&, std::vector<std::string> measures = {}, const Study* study = nullptr,
                        const Overrides& relative_to = {});

} // namespace placedpar
