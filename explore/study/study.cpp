#include "explore/study/study.hpp"

#include "text/counted.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace placedpar {

namespace {

constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();

[[noreturn]] void refuse_endless(const std::string& why) {
    throw UserError(fmt::format("the study has too many runs to count: {} are more than {}", why, most));
}

/// Throws UserError for a product with too many runs; the message names the settings that cause it.
[[noreturn]] void refuse_endless(const StudyProduct& product, std::uint64_t seeds) {
    std::size_t several = 0;
    std::string values;
    for (const StudyAxis& axis : product.axes)
        if (std::uint64_t count = axis.count(); count > 1)
            values += fmt::format("{}{} of {}", several++ == 0 ? "" : ", ", count, axis.name);
    refuse_endless(fmt::format("all combinations of {} with several values ({}), each run with {},",
                               counted(several, "setting"), values, counted(seeds, "seed")));
}

std::uint64_t count_with(std::uint64_t seeds, const StudyProduct& product) {
    std::uint64_t runs = seeds;
    for (const StudyAxis& axis : product.axes) {
        std::uint64_t values = axis.count();
        if (values != 0 && runs > most / values)
            refuse_endless(product, seeds);
        runs *= values;
    }
    return runs;
}

} // namespace

void require_seeds(std::uint64_t first, std::uint64_t seeds) {
    if (seeds == 0)
        throw UserError("the number of seeds is 0, expected at least 1");
    if (first > most - (seeds - 1))
        throw UserError(
            fmt::format("{} from {} on are too many: the greatest seed is {}", counted(seeds, "seed"), first, most));
}

Overrides StudyTable::set(const StudyRow& row, const StudyVariant& column) const {
    Overrides set = row.runs.set;
    set.insert(column.set.begin(), column.set.end());
    set.insert(shared.begin(), shared.end());
    return set;
}

std::uint64_t StudyProduct::count() const { return count_with(1, *this); }

Overrides StudyProduct::at(std::uint64_t index) const {
    Overrides set;
    for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {
        set[axis->name] = axis->at(index % axis->count());
        index /= axis->count();
    }
    return set;
}

bool StudyProduct::has(const Overrides& set) const {
    auto agrees = [&](const StudyAxis& axis) {
        auto found = set.find(axis.name);
        return found != set.end() && axis.find({axis.name, found->second}).has_value();
    };
    return set.size() == axes.size() && std::ranges::all_of(axes, agrees) && where.holds(set);
}

StudyRuns::StudyRuns(const Study& study) : study_(study) {
    require_seeds(study.first_seed, study.seeds);
    for (const StudyProduct& product : study.products) {
        std::uint64_t runs = count_with(study.seeds, product);
        if (runs > most - count())
            refuse_endless(
                fmt::format("the {} of [set] and [[also]] together", counted(study.products.size(), "product")));
        ends_.push_back(count() + runs);
    }
}

std::optional<StudyRun> StudyRuns::at(std::uint64_t index) const {
    const auto end = std::ranges::upper_bound(ends_, index);
    if (end == ends_.end())
        return std::nullopt;
    const StudyProduct& product = study_.products[static_cast<std::size_t>(end - ends_.begin())];
    index -= end == ends_.begin() ? 0 : *std::prev(end);
    Overrides set = product.at(index / study_.seeds);
    if (!product.where.holds(set))
        return std::nullopt;
    return StudyRun{std::move(set), study_.first_seed + index % study_.seeds};
}

std::uint64_t Study::count() const { return StudyRuns(*this).count(); }

std::optional<StudyRun> Study::at(std::uint64_t index) const { return StudyRuns(*this).at(index); }

std::vector<std::string> Study::names() const {
    std::set<std::string> names;
    for (const StudyProduct& product : products)
        for (const StudyAxis& axis : product.axes)
            names.insert(axis.name);
    return {names.begin(), names.end()};
}

std::optional<SettingValue> Study::find(const std::string& name, const SettingValue& value) const {
    std::optional<SettingValue> found;
    for (const StudyProduct& product : products)
        for (const StudyAxis& axis : product.axes)
            if (axis.name == name)
                if (std::optional<SettingValue> same = axis.find(value))
                    found = found ? better_spelt(*found, *same) : *same;
    return found;
}

bool Study::has_some(const Overrides& set) const {
    return std::ranges::any_of(products, [&](const StudyProduct& product) {
        return std::ranges::all_of(set, [&](const auto& setting) {
            auto axis = std::ranges::find(product.axes, setting.first, &StudyAxis::name);
            return axis != product.axes.end() && axis->find({axis->name, setting.second}).has_value();
        });
    });
}

} // namespace placedpar
