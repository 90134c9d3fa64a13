#include "identification/on_line/population_sets.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

struct NamedSet {
    std::string_view name;
    LinkSet links;
};

constexpr Link bu = Link::bucket, bo = Link::boom, st = Link::stick, sw = Link::swing;

/// The sets of links in Figure 3.13, in the order of the figure.
constexpr std::array<NamedSet, 15> figure_3_13{{
    {"P1a", {bu}},
    {"P1b", {bo}},
    {"P1c", {st}},
    {"P1d", {sw}},
    {"P2a", {bu, bo}},
    {"P2b", {st, sw}},
    {"P2c", {bu, st}},
    {"P2d", {bu, sw}},
    {"P2e", {bo, st}},
    {"P2f", {bo, sw}},
    {"P3a", {bu, bo, st}},
    {"P3b", {bu, bo, sw}},
    {"P3c", {bo, st, sw}},
    {"P3d", {bu, st, sw}},
    {"P4", {bu, bo, st, sw}},
}};

} // namespace

const std::array<LinkSet, 15>& all_population_sets() {
    static const std::array<LinkSet, 15> sets = [] {
        std::array<LinkSet, 15> links;
        std::ranges::transform(figure_3_13, links.begin(), &NamedSet::links);
        return links;
    }();
    return sets;
}

std::string_view name_of_set(LinkSet links) {
    auto found = std::ranges::find(figure_3_13, links, &NamedSet::links);
    assert(found != figure_3_13.end());
    return found->name;
}

std::optional<LinkSet> set_named(std::string_view name) {
    auto found = std::ranges::find(figure_3_13, name, &NamedSet::name);
    return found == figure_3_13.end() ? std::nullopt : std::optional(found->links);
}

std::vector<Link> links_of(LinkSet set) {
    std::vector<Link> links;
    std::ranges::copy_if(all_links, std::back_inserter(links), [&](Link link) { return set.contains(link); });
    return links;
}

std::size_t position_in(LinkSet set, Link link) {
    std::vector<Link> links = links_of(set);
    return static_cast<std::size_t>(std::ranges::find(links, link) - links.begin());
}

std::vector<LinkSet> sets_in_use(Configuration configuration, LinkSet active) {
    std::vector<LinkSet> sets;
    for (LinkSet group : coupled_groups(configuration))
        if (LinkSet set = group & active; !set.empty())
            sets.push_back(set);
    std::ranges::sort(sets, {}, name_of_set);
    return sets;
}

} // namespace placedpar::identification
