#include "explore/problems.hpp"
#include "gaprocs/policies/nouns.hpp"
#include "report/kinds_choice.hpp"
#include "report/policies_report.hpp"

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

TEST_CASE("each step decided by a parameter is listed with the policies that the parameter accepts") {
    Known known;
    auto nouns = policy_nouns();
    std::set<std::string> decided;
    for (const auto& each : known.catalogue.kinds()) // CAPTURE is a lambda: no structured binding in Clang 14
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
    for (const Noun& noun : nouns) // without a parameter, the variants show the spelling
        CHECK((decided.count(noun.name) == 1) == (noun.name != "distributed-fitness"));
}

TEST_CASE("steps decided by numbers, the problem or connections are listed with their netlist form") {
    Known known;
    CHECK(says(print_policy(known.catalogue, "best"), "\n  in a netlist: elite = 1\n  source: K. De Jong, 1975\n"));
    CHECK(says(print_policy(known.catalogue, "Distributed Fitness"),
               "\n\ndistributed\n  each island has its own window"));
    CHECK(says(print_policy(known.catalogue, "permutation"), "problem = \"tour-circle(cities = 12)\""));
    CHECK(says(print_policy(known.catalogue, "spread"), "\n  in a netlist: initial = \"spread\"\n"));
    std::string star = print_policy(known.catalogue, "star"); // "star" is a form for islands, and for a master and its
                                                              // slaves
    CHECK(says(star, "topology = \"star\""));
    CHECK(says(star, "connect master.to_slaves[1] to slave[1].from_master;"));
    CHECK_THROWS_WITH(print_policy(known.catalogue, "tree(3)"), "tree takes no number");
    CHECK_FALSE(says(print_policy(known.catalogue, "best(2)"), "elitism"));
}

TEST_CASE("synonyms lead to the right step") {
    Known known;
    std::string migration = print_policy(known.catalogue, "migration");
    for (const char* noun : {"topology\n", "schedule\n", "emigration\n", "acceptance\n"})
        CHECK(says(migration, noun));
    CHECK(print_policy(known.catalogue, "mutation_rate") == print_policy(known.catalogue, "mutation"));
    CHECK(print_policy(known.catalogue, "immigrants") == print_policy(known.catalogue, "acceptance"));
    CHECK(says(print_policy(known.catalogue, "operator"), "crossover_operator"));
    CHECK(says(print_policy(known.catalogue, "operator"), "mutation_operator"));
    CHECK_FALSE(is_policy(known.catalogue, "roulette wheel"));
}

TEST_CASE("descriptions of parameters are aligned in one column") {
    std::string listed = print_policies();
    std::size_t line = listed.find("    breeder(range = 0.1, precision = 24) a step");
    REQUIRE(line != std::string::npos);
    auto column = [&](const char* about) {
        std::size_t found = listed.find(about);
        return found - listed.rfind('\n', found);
    };
    CHECK(column("a step is added or subtracted") == column("how parents are chosen"));
    CHECK(column("a step is added or subtracted") == column("the master has a channel"));
}

TEST_CASE("kinds with a different default of a parameter are listed separately") {
    Known known;
    Catalogue other;
    ProcessKind master = *known.catalogue.find("ga.master"), island = *known.catalogue.find("ga.island");
    for (ParameterDescription& parameter : island.parameters)
        if (parameter.name == "elite")
            parameter.default_value = Value(std::int64_t{7});
    other.add(master);
    other.add(island);
    std::string elitism = print_policy(other, "elitism");
    CHECK(says(elitism, " of ga.master\n"));
    CHECK(says(elitism, " of ga.island\n"));
    CHECK(says(elitism, "default 7 "));
    CHECK(says(print_policy(other, "mutation"), " of ga.island, ga.master\n"));
}

TEST_CASE("no name has two meanings") {
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

TEST_CASE("a policy is described with its netlist form, its numbers and its source") {
    Known known;
    std::string tournament = print_policy(known.catalogue, "tournament");
    CHECK(says(tournament, "selection\nhow parents are chosen\n"));
    CHECK(says(tournament, "in a netlist: reproduction = \"tournament(size = 2)\"\n"));
    CHECK(says(tournament, "source: D. Goldberg and K. Deb, 1991\n"));
    CHECK(says(tournament, "  size             int     default 2              1 .. 1000000\n"));
    CHECK(says(tournament, "in a netlist: emigration = \"tournament(count = 1, size = 2)\"\n"));
    CHECK(says(print_policy(known.catalogue, "tournament(5)"), "reproduction = \"tournament(size = 5)\"\n"));
    CHECK_FALSE(says(print_policy(known.catalogue, "tournament(5, 6)"), "selection")); // selection has only one number
    CHECK(says(print_policy(known.catalogue, "reproduction"), "\nroulette\n"));
    CHECK(says(print_policy(known.catalogue, "elitism"), "  elite  "));
}
