#include "occam/check/usage.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <variant>

namespace placedpar::occam {

namespace {

constexpr std::int64_t most_components = 65536; ///< largest number of components of a replicated PAR that are compared
constexpr std::size_t most_outer_values =
    256; ///< largest number of values that are tried for the replicators that contain a PAR
constexpr std::size_t most_inner_values = 65536;

bool is_conflict(AccessKind a, AccessKind b) {
    if (a == AccessKind::input || a == AccessKind::output)
        return a == b;
    return a == AccessKind::write || b == AccessKind::write;
}

bool may_conflict(AccessKind kind) { return kind != AccessKind::read; }

} // namespace

void UsageCheck::report_parallel(const Access& first, const Access& second) {
    const bool first_is_later = std::pair(first.at.line, first.at.column) > std::pair(second.at.line, second.at.column);
    const Access& later = first_is_later ? first : second;
    const Access& earlier = first_is_later ? second : first;
    const std::string name = "\"" + later.base->name + "\"";
    const std::string through = later.through ? ", through \"" + later.through->name + "\"" : "";
    const auto verb = [](AccessKind kind) { return kind == AccessKind::write ? "changes" : "uses"; };
    std::string message, hint;
    if (later.kind == AccessKind::input || later.kind == AccessKind::output) {
        const bool is_output = later.kind == AccessKind::output;
        message = "two components of a PAR " + std::string(is_output ? "output to " : "input from ") + name + through;
        hint = "a channel joins two processes: use one channel for each pair of processes";
    } else {
        message = "a component of a PAR " + std::string(verb(later.kind)) + " " + name + through +
                  (through.empty() ? ", which another component " : "; another component ") + verb(earlier.kind) +
                  (through.empty() ? "" : " it");
        hint = "send the value over a channel, or use a variable for each component";
    }
    std::vector<SecondPlace> others;
    if (!(earlier.at == later.at))
        others.push_back({"the other use is here", program_.location(earlier.at)});
    reporter_.error(program_.location(later.at), message, hint, std::move(others));
}

/// Reports the first two components that use the same elements of an array in a forbidden way. Returns true if there
/// are none.
bool UsageCheck::check_intervals(std::vector<Interval>& intervals) {
    const auto begins_earlier = [](const Interval& a, const Interval& b) { return a.region.first < b.region.first; };
    std::ranges::stable_sort(intervals, begins_earlier);
    std::vector<const Interval*> reads, others; // earlier intervals that may overlap with the next interval
    for (const Interval& each : intervals) {
        const auto is_over = [&](const Interval* open) { return open->region.end <= each.region.first; };
        const auto conflicts = [&](const Interval* open) {
            return open->component != each.component && is_conflict(open->access->kind, each.access->kind);
        };
        std::erase_if(others, is_over);
        auto found = std::ranges::find_if(others, conflicts);
        const Interval* other = found == others.end() ? nullptr : *found;
        if (!other && may_conflict(each.access->kind)) {
            std::erase_if(reads, is_over);
            found = std::ranges::find_if(reads, conflicts);
            other = found == reads.end() ? nullptr : *found;
        }
        if (other) {
            report_parallel(*other->access, *each.access);
            return false;
        }
        (may_conflict(each.access->kind) ? others : reads).push_back(&each);
    }
    return true;
}

/// Adds the interval of the elements that an access uses: one interval for each component of a replicated PAR, and for
/// each value of the replicators in the component.
void UsageCheck::intervals_of(const Parallel& parallel, std::int64_t component, const Access& access,
                              IndexValues& values, std::vector<Interval>& intervals) {
    std::vector<const Declaration*> indices, inner;
    add_indices(access, indices);
    const Declaration* const own = parallel.replicator ? parallel.replicator->index.get() : nullptr;
    for (const Declaration* const index : indices) {
        if (index != own && !open_indices_.contains(index))
            inner.push_back(index);
    }
    const bool is_replicated = own && std::ranges::find(indices, own) != indices.end();
    const std::int64_t count = own ? std::min(parallel.replicator->count.constant->bits, most_components) : 1;
    const std::optional<std::int64_t> base = own ? value_of(parallel.replicator->base, values) : 0;
    const std::optional<std::int64_t> step =
        own && parallel.replicator->step ? value_of(*parallel.replicator->step, values) : 1;
    // If the access does not depend on the index, it is the same in all components, and comparing two components
    // suffices.
    const std::int64_t different = is_replicated && base && step ? count : std::min<std::int64_t>(count, 2);
    for (std::int64_t i = 0; i < different; ++i) {
        if (own && base && step)
            values[own] = *base + i * *step;
        const auto add = [&](const IndexValues& given) {
            const Region region = region_of(access, given);
            const bool is_repeated = !intervals.empty() && intervals.back().access == &access &&
                                     intervals.back().component == component + i &&
                                     intervals.back().region.first == region.first;
            if (!is_repeated)
                intervals.push_back({region, component + i, &access});
            return true;
        };
        const std::size_t most = std::max<std::size_t>(1, most_inner_values / static_cast<std::size_t>(different));
        for_each_value(inner, replicators_, most, values, add);
    }
    if (own)
        values.erase(own);
}

bool UsageCheck::check_base(const Parallel& parallel,
                            const std::vector<std::pair<std::int64_t, const Access*>>& accesses) {
    std::vector<const Declaration*> indices, outer;
    for (const auto& [component, access] : accesses)
        add_indices(*access, indices);
    if (parallel.replicator) {
        Access of_base;
        of_base.steps.push_back({.index = &parallel.replicator->base});
        add_indices(of_base, indices);
    }
    for (const Declaration* const index : indices) {
        if (open_indices_.contains(index) && !(parallel.replicator && index == parallel.replicator->index.get()))
            outer.push_back(index);
    }
    bool is_right = true;
    IndexValues values;
    for_each_value(outer, replicators_, most_outer_values, values, [&](const IndexValues& given) {
        IndexValues all = given;
        std::vector<Interval> intervals;
        for (const auto& [component, access] : accesses)
            intervals_of(parallel, component, *access, all, intervals);
        is_right = check_intervals(intervals);
        return is_right;
    });
    return is_right;
}

void UsageCheck::check_parallel(const Parallel& parallel, const std::vector<Stretch>& components, std::uint64_t since) {
    if (parallel.replicator && (!parallel.replicator->count.constant || parallel.replicator->count.constant->bits < 2))
        return;
    std::vector<const Declaration*> order; // bases in order of their first use
    std::unordered_map<const Declaration*, std::vector<std::pair<std::int64_t, const Access*>>> by_base;
    for (std::size_t component = 0; component < components.size(); ++component) {
        for (std::size_t i = components[component].first; i < components[component].end; ++i) {
            const Access& access = log_[i];
            const auto declared = declared_.find(access.base);
            if (declared != declared_.end() && declared->second >= since)
                continue;
            auto& accesses = by_base[access.base];
            if (accesses.empty())
                order.push_back(access.base);
            accesses.emplace_back(static_cast<std::int64_t>(component), &access);
        }
    }
    for (const Declaration* const base : order) {
        const auto& accesses = by_base[base];
        const bool is_shared = parallel.replicator || accesses.front().first != accesses.back().first;
        const bool is_changed = std::ranges::any_of(accesses, [](const std::pair<std::int64_t, const Access*>& each) {
            return may_conflict(each.second->kind);
        });
        if (is_shared && is_changed)
            check_base(parallel, accesses);
    }
}

} // namespace placedpar::occam
