#pragma once

#include "explore/study/study.hpp"

#include <set>
#include <vector>

namespace placedpar {

/// Finds out whether a study has runs with given settings. A study's tables can make thousands of products with a
/// single combination each. A set holds these combinations for fast search. Only products with several combinations are
/// searched one by one.
class StudySettings {
public:
    StudySettings() = default;
    explicit StudySettings(const std::vector<StudyProduct>&);

    void add(const StudyProduct&);
    /// Returns whether there are runs with these settings, in any spelling.
    bool has(const Overrides&) const;

private:
    std::set<Overrides> single_; ///< products with a single combination: names of settings and meanings of their values
    std::vector<StudyProduct> others_;
};

} // namespace placedpar
