// Tests the descriptions in the experiments' files.

#include "experiments/kit/experiment.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace placedpar;

TEST_CASE("experiments are listed by chapter and number, with appendices and the machine last") {
    Experiment second{"second", "", "2", 2, nullptr}, third{"third", "", "3", 1, nullptr},
        appendix{"appendix", "", "E", 1, nullptr}, machine{"machine", "", "machine", 1, nullptr},
        first{"first", "", "2", 1, nullptr};
    std::vector<std::string_view> names;
    for (const Experiment& each : in_order({machine, appendix, third, second, first}))
        names.push_back(each.name);
    CHECK(names == std::vector<std::string_view>{"first", "second", "third", "appendix", "machine"});
}

TEST_CASE("every experiment has a name, a distinct place, a description, and a function to run") {
    std::set<std::string_view> names;
    std::set<std::pair<std::string_view, int>> places;
    for (const Experiment& each : experiments()) {
        CHECK(names.insert(each.name).second);
        CHECK(places.emplace(each.chapter, each.number).second);
        CHECK_FALSE(each.about.empty());
        CHECK_FALSE(!each.run);
    }
    CHECK(experiments().front().name == "table-2-6");
    CHECK(experiments().back().name == "evidence");
}

TEST_CASE("a replay without processes has the fingerprint of its tables as they are printed") {
    auto fingerprint = [](double figure, const char* note) {
        return replay_of({{.name = "table", .cells = {plain_cell("x", "a", "", figure, 2)}, .notes = note}}, {})
            .fingerprint;
    };
    CHECK(fingerprint(1.5, "") == fingerprint(1.5 + 1e-12, "")); // the last bits do not count
    CHECK(fingerprint(1.5, "") != fingerprint(1.51, ""));
    CHECK(fingerprint(1.5, "") != fingerprint(1.5, "but"));
}
