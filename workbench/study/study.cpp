#include "workbench/study/study.hpp"

#include "text/user_error.hpp"

#include <limits>
#include <utility>

namespace placedpar {

namespace {

[[noreturn]] void refuse_endless() { throw UserError("the study has more runs than can be counted"); }

std::uint64_t product_of(std::uint64_t a, std::uint64_t b) {
    if (b != 0 && a > std::numeric_limits<std::uint64_t>::max() / b)
        refuse_endless();
    return a * b;
}

} // namespace

std::uint64_t StudyProduct::count() const {
    std::uint64_t count = 1;
    for (const StudyAxis& axis : axes)
        count = product_of(count, axis.count());
    return count;
}

Overrides StudyProduct::at(std::uint64_t index) const {
    Overrides set;
    for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis) {
        set[axis->name] = axis->at(index % axis->count());
        index /= axis->count();
    }
    return set;
}

std::uint64_t Study::count() const {
    std::uint64_t sum = 0;
    for (const StudyProduct& product : products) {
        std::uint64_t count = product_of(product.count(), seeds);
        if (sum + count < sum)
            refuse_endless();
        sum += count;
    }
    return sum;
}

std::optional<StudyRun> Study::at(std::uint64_t index) const {
    for (const StudyProduct& product : products) {
        std::uint64_t count = product.count() * seeds;
        if (index >= count) {
            index -= count;
            continue;
        }
        Overrides set = product.at(index / seeds);
        if (!product.where.holds(set))
            return std::nullopt;
        return StudyRun{std::move(set), first_seed + index % seeds};
    }
    return std::nullopt;
}

std::set<Overrides> Study::combinations() const {
    std::set<Overrides> all;
    for (const StudyProduct& product : products)
        for (std::uint64_t i = 0, count = product.count(); i < count; ++i)
            if (Overrides set = product.at(i); product.where.holds(set))
                all.insert(std::move(set));
    return all;
}

} // namespace placedpar
