#include "explore/study/study_settings.hpp"

#include "explore/study/setting_value.hpp"

#include <algorithm>

namespace placedpar {

namespace {

bool is_single(const StudyProduct& product) {
    return !product.where && std::ranges::all_of(product.axes, [](const StudyAxis& axis) {
        return axis.parts.size() == 1 && !axis.parts.front().is_range();
    });
}

Overrides meanings_of(const Overrides& set) {
    Overrides meanings;
    for (const auto& [name, text] : set)
        meanings[name] = SettingValue(name, text).meaning();
    return meanings;
}

} // namespace

StudySettings::StudySettings(const std::vector<StudyProduct>& products) {
    for (const StudyProduct& product : products)
        add(product);
}

void StudySettings::add(const StudyProduct& product) {
    if (is_single(product))
        single_.insert(meanings_of(product.at(0)));
    else
        others_.push_back(product);
}

bool StudySettings::has(const Overrides& set) const {
    return (!single_.empty() && single_.contains(meanings_of(set))) ||
           std::ranges::any_of(others_, [&](const StudyProduct& product) { return product.has(set); });
}

} // namespace placedpar
