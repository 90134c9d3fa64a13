#include "identification/on_line/population_sets.hpp"

#include <doctest/doctest.h>

#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

/// Each line has the active links, then the sets of configurations a, b and c, and then the sets of both d and e.
constexpr const char* table = R"(
BU P1a P1a P1a P1a
BO P1b P1b P1b P1b
ST P1c P1c P1c P1c
SW P1d P1d P1d P1d
BU+BO P2a P1a+P1b P2a P2a
BU+ST P1a+P1c P1a+P1c P2c P2c
BU+SW P1a+P1d P1a+P1d P1d+P1a P2d
BO+ST P1b+P1c P2e P2e P2e
BO+SW P1b+P1d P2f P1d+P1b P2f
ST+SW P2b P2b P1d+P1c P2b
BU+BO+ST P2a+P1c P1a+P2e P3a P3a
BU+BO+SW P2a+P1d P1a+P2f P1d+P2a P3b
BU+ST+SW P1a+P2b P1a+P2b P1d+P2c P3d
BO+ST+SW P1b+P2b P3c P1d+P2e P3c
BU+BO+ST+SW P2a+P2b P1a+P3c P1d+P3a P4
)";

std::set<std::string> split(const std::string& text) {
    std::set<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, '+');)
        parts.insert(part);
    return parts;
}

LinkSet links_from(const std::string& text) {
    LinkSet links;
    for (const std::string& symbol : split(text))
        links.insert(link_named(symbol).value());
    return links;
}

std::set<std::string> names_in_use(Configuration configuration, LinkSet active) {
    std::set<std::string> names;
    for (LinkSet set : sets_in_use(configuration, active))
        names.emplace(name_of_set(set));
    return names;
}

} // namespace

TEST_CASE("the sets of every configuration and every choice of active links are those of the table") {
    std::istringstream in(table);
    std::set<LinkSet> seen;
    for (std::string active, a, b, c, d; in >> active >> a >> b >> c >> d;) {
        CAPTURE(active);
        LinkSet links = links_from(active);
        seen.insert(links);
        CHECK(names_in_use(Configuration::a, links) == split(a));
        CHECK(names_in_use(Configuration::b, links) == split(b));
        CHECK(names_in_use(Configuration::c, links) == split(c));
        CHECK(names_in_use(Configuration::d, links) == split(d));
        CHECK(names_in_use(Configuration::e, links) == split(d));
    }
    CHECK(seen.size() == 15);
}

TEST_CASE("the fifteen sets are distinct and have the sizes of Figure 3.13") {
    std::set<LinkSet> sets;
    std::set<std::string> names;
    for (LinkSet set : all_population_sets()) {
        sets.insert(set);
        std::string name(name_of_set(set));
        names.insert(name);
        CHECK(set_named(name) == set);
        CHECK(set.size() == static_cast<std::size_t>(name[1] - '0'));
    }
    CHECK(sets.size() == 15);
    CHECK(names.size() == 15);
    CHECK_FALSE(set_named("P5"));
}

TEST_CASE("each configuration uses the number of sets of Figure 3.13") {
    for (auto [configuration, count] : {std::pair{Configuration::a, 6u},
                                        {Configuration::b, 8u},
                                        {Configuration::c, 8u},
                                        {Configuration::d, 15u},
                                        {Configuration::e, 15u}}) {
        std::set<LinkSet> used;
        for (LinkSet active : all_population_sets())
            for (LinkSet set : sets_in_use(configuration, active))
                used.insert(set);
        CHECK(used.size() == count);
    }
}

TEST_CASE("without an active link there is no set") { CHECK(sets_in_use(Configuration::a, {}).empty()); }
