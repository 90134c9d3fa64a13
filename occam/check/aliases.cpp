#include "occam/check/checker.hpp"
#include "occam/check/usage.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

namespace placedpar::occam {

namespace {

/// Returns ", through "p"" for an access that the body of the called routine p makes; "" for any other access.
std::string through_text(const Access& access) {
    return access.through ? ", through \"" + access.through->name + "\"" : "";
}

/// Returns whether an abbreviation names `other` or a part of it, directly or through further abbreviations.
bool is_part_of(const Declaration& abbreviation, const Declaration* other) {
    const Declaration* each = named_by(abbreviation);
    while (each && each != other)
        each = named_by(*each);
    return each != nullptr;
}

} // namespace

/// Returns whether an access uses the name of this abbreviation, or of a later abbreviation. A later abbreviation was
/// compared with this abbreviation when it was declared.
bool UsageCheck::is_named_by(const Access& access, const Declaration& abbreviation) const {
    if (access.root == access.base)
        return false;
    const auto root = declared_.find(access.root), earlier = declared_.find(&abbreviation);
    return root != declared_.end() && earlier != declared_.end() && root->second >= earlier->second;
}

void UsageCheck::check_active(const Access& access) {
    if (!aliases_ || access.kind == AccessKind::input || access.kind == AccessKind::output)
        return;
    for (const Active& active : active_) {
        const bool is_harmless = !active.is_changeable && access.kind == AccessKind::read;
        if (active.access.base != access.base || is_harmless || is_named_by(access, *active.declaration))
            continue;
        const Overlap overlap = overlap_of(active.access, access, replicators_);
        // Two abbreviations are refused only if they certainly name the same element.
        const bool is_other = access.root != access.base && !is_part_of(*active.declaration, access.root);
        if (overlap == Overlap::none || (overlap == Overlap::possible && (access.is_abbreviation || is_other)))
            continue;
        const std::string name = "\"" + access.root->name + "\"", other = "\"" + active.declaration->name + "\"";
        const std::string message = active.is_changeable
                                        ? name + " cannot be used here: it has been abbreviated as " + other
                                        : name + " cannot be changed here: " + other + " depends on it";
        reporter_.error(program_.location(access.at), message + through_text(access),
                        active.is_changeable ? "use " + other : "",
                        {{other + " is declared here", program_.location(active.declaration->at)}});
        return;
    }
}

void UsageCheck::check_free(const Declaration& routine, const std::vector<Part>& parts, const Place& place) {
    const auto summary = summaries_.find(&routine);
    if (summary == summaries_.end())
        return;
    for (const Access& free : summary->second) {
        const auto meets = [&](const Access& access, bool is_changed) {
            return access.base == free.base && (is_changed || free.kind == AccessKind::write) &&
                   overlap_of(access, free, replicators_) != Overlap::none;
        };
        const auto is_alias = [&](const Part& part) {
            return (part.changed && meets(*part.changed, true)) ||
                   std::ranges::any_of(part.read, [&](const Access& access) { return meets(access, false); });
        };
        if (free.kind != AccessKind::read && free.kind != AccessKind::write)
            continue;
        if (std::ranges::any_of(parts, is_alias))
            return reporter_.error(program_.location(place),
                                   "\"" + free.base->name + "\" is passed as a parameter, but \"" + routine.name +
                                       "\" also uses it directly",
                                   "pass another variable", {{"used here", program_.location(free.at)}});
    }
}

/// Refuses an assignment between overlapping parts of one array.
void UsageCheck::check_block(const Expression& target, const Expression& value) {
    if (!target.type || target.type->kind != Type::Kind::array)
        return;
    const std::optional<Access> to = access_of(target, AccessKind::write), from = access_of(value, AccessKind::read);
    if (!to || !from || to->base != from->base || to->steps == from->steps)
        return;
    const Region first = region_of(*to, {}), second = region_of(*from, {});
    const bool are_equal = first.first == second.first && first.end == second.end;
    if (!are_equal && overlap_of(*to, *from, replicators_) == Overlap::certain)
        reporter_.error(program_.location(target.at),
                        "\"" + to->base->name + "\" is assigned to itself, and the source overlaps the target",
                        "copy the source to another array first");
}

/// Refuses overlapping arguments of a call, or overlapping targets of an assignment.
void UsageCheck::check_parts(const std::vector<Part>& parts, bool only_certain, const std::string& what) {
    const auto meet = [&](const Access& a, const Access& b) {
        const Overlap overlap = a.base == b.base ? overlap_of(a, b, replicators_) : Overlap::none;
        return overlap == Overlap::certain || (overlap == Overlap::possible && !only_certain);
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (std::size_t j = 0; parts[i].changed && j < parts.size(); ++j) {
            const Access& changed = *parts[i].changed;
            const Access* other =
                j > i && parts[j].changed && meet(changed, *parts[j].changed) ? &*parts[j].changed : nullptr;
            for (const Access& read : parts[j].read)
                other = j != i && !other && meet(changed, read) ? &read : other;
            if (!other)
                continue;
            const std::string name = "\"" + changed.base->name + "\"";
            return reporter_.error(
                program_.location(other->at),
                name + (other->kind == AccessKind::write ? " is changed twice " : " is changed and used ") + what,
                only_certain ? "pass another variable" : "use two assignments",
                {{"changed here", program_.location(changed.at)}});
        }
    }
}

} // namespace placedpar::occam
