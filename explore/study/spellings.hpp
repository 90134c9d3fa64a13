#pragma once

#include "explore/study/results.hpp"

#include <functional>
#include <map>
#include <string>

namespace placedpar {

/// One spelling for all values that mean the same: the study's, if there is one that has them, or that of the first
/// run.
class Spellings {
public:
    /// REQUIRES: both outlive it.
    Spellings(StudyResults&, const Study*);

    /// The same settings in that spelling.
    Overrides of(Overrides set);
    /// Runs with their settings in that spelling. Of those that are the same then, one: that which was made so.
    void for_each(const std::function<void(const StudyRun&, const StudyOutcome&)>&);

private:
    const std::string& spelt(const std::string& name, const std::string& text);

    StudyResults& results_;
    const Study* study_;
    std::map<std::string, std::map<std::string, std::string>> known_, ///< by name and text
        of_runs_;                                                     ///< by name and meaning
    bool differ_ = false;                                             ///< whether some run is spelt otherwise
};

} // namespace placedpar
