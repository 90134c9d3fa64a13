#pragma once

#include "explore/study/results.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace placedpar {

/// A measure over the runs of one combination that came to an end.
struct StudyCell {
    std::uint64_t runs = 0;
    double mean = 0, least = 0, greatest = 0;
    double half_width = 0; ///< of Student's interval: with 95 % the mean is within; 0 for a single run

    void add(double value);
    /// REQUIRES: nothing is added any more.
    void close();

private:
    double squares_ = 0; ///< of the distances from the mean (B. Welford, 1962)
};

/// The runs of one combination.
struct StudyLine {
    std::vector<std::string> values;            ///< of the axes; "" where this one does not set one
    std::uint64_t runs = 0;                     ///< all
    std::map<std::string, std::uint64_t> ended; ///< those that did not complete, by how they ended
    std::string refused = "";                   ///< why, by its first line
    std::vector<StudyCell> cells;               ///< by measure
};

/// What is known of a study's runs.
struct StudySummary {
    std::string netlist, version;
    std::vector<std::string> axes = {}; ///< that have several values
    Overrides fixed = {};               ///< what all combinations set to the same
    Overrides relative_to = {};         ///< figures are relative to those with these settings; none: as they are
    std::uint64_t unrelated = 0;        ///< runs with figures for which there is none of these
    std::vector<std::string> measures = {}, units = {};
    std::vector<StudyLine> lines = {}; ///< in the order of the values, numbers as numbers

    std::uint64_t runs() const;
    /// What its runs set.
    std::vector<std::string> names() const;
    /// Whether some line has all of these settings.
    bool has_some(const Overrides&) const;
};

/// Of the runs that are kept; of a study that is swept, of those with its combinations, whatever their seeds. Without
/// measures, of those that were asked for last. Relative to some settings, each figure is divided by that of the run
/// that has them and is otherwise the same, its seed too, and ended in the same way; where there is none of these,
/// there is no figure. Settings that are equal are one, as the study spells them (SettingValue).
StudySummary summary_of(StudyResults&, std::vector<std::string> measures = {}, const Study* study = nullptr,
                        const Overrides& relative_to = {});

} // namespace placedpar
