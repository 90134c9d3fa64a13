// Tests what a name may mean where kinds are expected, and the message for an unknown name.

#include "report/kinds_choice.hpp"

#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace placedpar;

namespace {

/// The devices of every catalogue, and three kinds of processes.
Catalogue two_groups() {
    Catalogue catalogue;
    for (const char* name : {"belt.loader", "belt.sorter", "press.stamper"})
        catalogue.add({.name = name, .about = "", .body = [](ProcessEnvironment&) {}});
    return catalogue;
}

std::vector<std::string> names_in(std::string_view group) {
    const Catalogue catalogue = two_groups();
    std::vector<std::string> names;
    for (const ProcessKind* kind : group_of(catalogue, group))
        names.push_back(kind->name);
    return names;
}

} // namespace

TEST_CASE("the group of a kind is the part of its name before the point; processes names all groups") {
    using Names = std::vector<std::string>;
    CHECK(names_in("belt") == Names{"belt.loader", "belt.sorter"});
    CHECK(names_in("processes") == Names{"belt.loader", "belt.sorter", "press.stamper"});
    CHECK(names_in("bel").empty());
    CHECK(names_in("belt.loader").empty()); // a kind, not a group
}

TEST_CASE("names are found in any case, and an exact match comes first") {
    const Catalogue catalogue = two_groups();
    CHECK(known_name(catalogue, "BELT.LOADER") == "belt.loader");
    CHECK(known_name(catalogue, "Press") == "press");
    CHECK(known_name(catalogue, "t800") == "t800"); // an alias of T800
    CHECK(known_name(catalogue, "Crane") == "Crane");
    const std::vector<std::string> names = known_names(catalogue);
    CHECK(std::ranges::is_sorted(names));
    CHECK(std::ranges::adjacent_find(names) == names.end());
}

TEST_CASE("the message about an unknown kind suggests the nearest name, a kind with its group, or the list") {
    const Catalogue catalogue = two_groups();
    auto refusal = [&](const std::string& name) {
        try {
            refuse_kind(catalogue, name, {"rastrigin"});
        } catch (const UserError& refused) {
            return std::string(refused.what());
        }
    };
    const std::string there_is_none = "unknown process kind, device, problem or policy ";
    CHECK(refusal("belt.loadr") == there_is_none + "\"belt.loadr\"; did you mean \"belt.loader\"?");
    CHECK(refusal("stamper") == there_is_none + "\"stamper\"; did you mean \"press.stamper\"?");
    CHECK(refusal("stampr") == there_is_none + "\"stampr\"; did you mean \"press.stamper\"?");
    CHECK(refusal("rastrgin") == there_is_none + "\"rastrgin\"; did you mean \"rastrigin\"?");
    CHECK(refusal("quite another") == there_is_none + "\"quite another\"; placedpar kinds lists all");
}
