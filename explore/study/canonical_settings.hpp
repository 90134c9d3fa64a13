#pragma once

#include "explore/study/results.hpp"

#include <functional>
#include <map>
#include <string>

namespace placedpar {

/// Chooses one spelling for all values of a setting with the same meaning, such as 8 and 8.0, so that tables list the
/// value once. This is the study's spelling if the study has the value, otherwise the spelling in the first run with
/// the value.
class CanonicalSettings {
public:
    /// REQUIRES: both arguments outlive this object.
    CanonicalSettings(StudyResults&, const Study*);

    /// Returns the same settings in the chosen spelling.
    Overrides of(Overrides set);
    /// Calls the function for each run, with its settings in the chosen spelling. If several runs
    /// differ only in spelling, only one of them is passed: the run with the chosen spelling, if there is such a run.
    void for_each(const std::function<void(const StudyRun&, const StudyOutcome&)>&);

private:
    const std::string& spelt(const std::string& name, const std::string& text);

    StudyResults& results_;
    const Study* study_;
    std::map<std::string, std::map<std::string, std::string>> known_, ///< chosen spelling, by name and text
        of_runs_;                                                     ///< chosen spelling, by name and meaning
    bool differ_ = false; ///< whether some run has a spelling that was not chosen
};

} // namespace placedpar
