#include "explore/study/canonical_settings.hpp"

#include <set>
#include <utility>

namespace placedpar {

CanonicalSettings::CanonicalSettings(StudyResults& results, const Study* study) : results_(results), study_(study) {
    results.for_each_setting([this](const Overrides& set) { differ_ |= of(set) != set; });
}

Overrides CanonicalSettings::of(Overrides set) {
    for (auto& [name, text] : set)
        text = spelt(name, text);
    return set;
}

const std::string& CanonicalSettings::spelt(const std::string& name, const std::string& text) {
    auto [known, is_new] = known_[name].try_emplace(text);
    if (!is_new)
        return known->second;
    const SettingValue value(name, text);
    std::optional<SettingValue> of_study = study_ ? study_->find(name, value) : std::nullopt;
    known->second = of_study ? of_study->spelling() : of_runs_[name].try_emplace(value.meaning(), text).first->second;
    return known->second;
}

void CanonicalSettings::for_each(const std::function<void(const StudyRun&, const StudyOutcome&)>& tell) {
    if (!differ_)
        return results_.for_each(tell);
    std::set<StudyRun> told;
    for (bool made_so : {true, false})
        results_.for_each([&](const StudyRun& run, const StudyOutcome& outcome) {
            StudyRun same{of(run.set), run.seed};
            if ((same == run) == made_so && told.insert(same).second)
                tell(same, outcome);
        });
}

} // namespace placedpar
