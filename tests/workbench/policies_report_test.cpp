#include "gaprocs/policies/nouns.hpp"
#include "workbench/kinds_choice.hpp"
#include "workbench/policies_report.hpp"
#include "workbench/problems.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct Known {
    ProblemRegistry problems = known_problems(0);
    Catalogue catalogue = known_kinds(problems);
};

std::vector<std::string> texts_of_policies(const Noun& noun) {
    std::vector<std::string> texts;
    for (const PolicyDescription& policy : noun.policies)
        texts.push_back(policy.text());
    return texts;
}

} // namespace

TEST_CASE("what a parameter decides is listed, with the very policies that the parameter takes") {
    Known known;
    auto nouns = policy_nouns();
    std::set<std::string> decided;
    for (const auto& each : known.catalogue.kinds()) // CAPTURE is a lambda, which Clang 14 lets capture no binding
        for (const ParameterDescription& parameter : each.second.parameters) {
            if (parameter.noun.empty())
                continue;
            CAPTURE(each.first + ": " + parameter.name);
            auto noun = std::ranges::find(nouns, parameter.noun, &Noun::name);
            REQUIRE(noun != nouns.end());
            decided.insert(noun->name);
            auto choices = parameter.choices;
            std::erase(choices, "usual");
            if (!parameter.check)
                continue;
            CHECK(choices == texts_of_policies(*noun));
            for (const std::string& choice : parameter.choices)
                CHECK_NOTHROW(parameter.check(choice));
        }
    for (const Noun& noun : nouns)
        CHECK(decided.count(noun.name) == 1);
}

TEST_CASE("every name stands for one thing only") {
    Known known;
    std::vector<std::string> names = known_names(known.catalogue), problems = known.problems.names(),
                             policies = policy_names();
    names.insert(names.end(), problems.begin(), problems.end());
    names.insert(names.end(), policies.begin(), policies.end());
    std::ranges::sort(names);
    CHECK(std::ranges::adjacent_find(names) == names.end());
    for (const std::string& name : policies)
        CHECK((name == policies_group || is_policy(known.catalogue, name)));
}

TEST_CASE("a policy says how a netlist writes it, its numbers and where it is from") {
    Known known;
    std::string tournament = print_policy(known.catalogue, "tournament");
    CHECK(says(tournament, "selection\nhow parents are chosen\n"));
    CHECK(says(tournament, "in a netlist: reproduction = \"tournament(size = 2)\"\n"));
    CHECK(says(tournament, "source: D. Goldberg and K. Deb, 1991\n"));
    CHECK(says(tournament, "  size             int     default 2              1 .. 1000000\n"));
    CHECK(says(tournament, "in a netlist: emigration = \"tournament(count = 1, size = 2)\"\n"));
    CHECK(says(print_policy(known.catalogue, "tournament(5)"), "reproduction = \"tournament(size = 5)\"\n"));
    CHECK_FALSE(says(print_policy(known.catalogue, "tournament(5, 6)"), "selection")); // which has one number
    CHECK(says(print_policy(known.catalogue, "reproduction"), "\nroulette\n"));
    CHECK(says(print_policy(known.catalogue, "elitism"), "  elite  "));
}
