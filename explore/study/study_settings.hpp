#pragma once

#include "explore/study/study.hpp"

#include <set>
#include <vector>

namespace placedpar {

/// Knows with which settings a study has runs. Thousands of products with one combination, as the cells of tables are,
/// are looked up by what their values mean; only the others are asked one by one.
class StudySettings {
public:
    StudySettings() = default;
    explicit StudySettings(const std::vector<StudyProduct>&);

    void add(const StudyProduct&);
    /// Whether there are runs with these settings, however they are spelled.
    bool has(const Overrides&) const;

private:
    std::set<Overrides> single_; ///< names and meanings
    std::vector<StudyProduct> others_;
};

} // namespace placedpar
