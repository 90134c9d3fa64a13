#include "report/kinds_choice.hpp"

#include "text/nearest.hpp"
#include "text/program_name.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace placedpar {

namespace {

/// Returns "master" for "ga.master"; the name itself if it has no group.
std::string_view name_in_group(std::string_view name) { return name.substr(name.find('.') + 1); }

/// Returns the kind whose name without its group equals this name or is similar to this name, since users leave the
/// group out. Returns "" if there is no such kind.
std::string kind_without_group(const Catalogue& catalogue, const std::string& name) {
    std::vector<std::string> short_names;
    for (const auto& [full, kind] : catalogue.kinds()) {
        if (name_in_group(full) == name)
            return full;
        short_names.emplace_back(name_in_group(full));
    }
    std::string nearest = nearest_name(name, short_names);
    return nearest.empty() ? "" : kind_without_group(catalogue, nearest);
}

} // namespace

std::vector<std::string> known_names(const Catalogue& catalogue) {
    std::set<std::string> names{std::string(processes_group), std::string(devices_group)};
    for (const auto& [name, kind] : catalogue.kinds())
        names.insert({name, name.substr(0, name.find('.'))});
    for (const auto& [name, type] : catalogue.node_types())
        names.insert(name);
    return {names.begin(), names.end()};
}

std::string known_name(const Catalogue& catalogue, const std::string& name) {
    std::vector<std::string> known = known_names(catalogue);
    auto is_like_it = [&](const std::string& each) { return lower_case(each) == lower_case(name); };
    if (std::ranges::find(known, name) != known.end())
        return name;
    auto found = std::ranges::find_if(known, is_like_it);
    return found == known.end() ? name : *found;
}

std::vector<const ProcessKind*> group_of(const Catalogue& catalogue, std::string_view group) {
    std::vector<const ProcessKind*> kinds;
    for (const auto& [name, kind] : catalogue.kinds())
        if (group == processes_group || name.starts_with(fmt::format("{}.", group)))
            kinds.push_back(&kind);
    return kinds;
}

void refuse_kind(const Catalogue& catalogue, const std::string& name, const std::vector<std::string>& others) {
    std::string meant = nearest_name(name, known_names(catalogue));
    if (meant.empty())
        meant = kind_without_group(catalogue, name);
    if (meant.empty())
        meant = nearest_name(name, others);
    throw UserError(fmt::format("unknown process kind, device, problem or policy \"{}\"; {}", name,
                                meant.empty() ? fmt::format("{} kinds lists all", program_name())
                                              : fmt::format("did you mean \"{}\"?", meant)));
}

const char* word(ParameterType type) {
    return type == ParameterType::integer ? "int" : type == ParameterType::real ? "double" : "string";
}

} // namespace placedpar
