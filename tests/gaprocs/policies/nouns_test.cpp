#include "gaprocs/policies/nouns.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <set>
#include <string>

using namespace placedpar;

namespace {

/// Calls `visit` with every noun and each of its policies.
template <class Visit>
void for_each_policy(Visit visit) {
    for (const Noun& noun : policy_nouns())
        for (const PolicyDescription& policy : noun.policies)
            visit(noun, policy);
}

/// Returns the default numbers with one number replaced.
std::vector<double> with_number(const PolicyDescription& policy, std::size_t which, double value) {
    std::vector<double> values;
    for (const PolicyNumberDescription& number : policy.numbers)
        values.push_back(number.by_default);
    values[which] = value;
    return values;
}

} // namespace

TEST_CASE("the parser accepts every listed policy and prints it as it is listed") {
    std::size_t policies = 0;
    for_each_policy([&](const Noun& noun, const PolicyDescription& policy) {
        CAPTURE(noun.name + ": " + policy.name);
        ++policies;
        auto printed_alone = noun.printed(policy.name), printed_whole = noun.printed(policy.text());
        CHECK(printed_alone == printed_whole);
        CHECK(noun.printed(printed_whole) == printed_whole);
        CHECK(policy.text().starts_with(printed_whole)); // a coding omits dont_care = 0
    });
    CHECK(policies == 48);
}

TEST_CASE("the parser accepts the listed ranges and nothing beyond") {
    for_each_policy([](const Noun& noun, const PolicyDescription& policy) {
        for (std::size_t i = 0; i < policy.numbers.size(); ++i) {
            const PolicyNumberDescription& number = policy.numbers[i];
            CAPTURE(noun.name + ": " + policy.name + ": " + number.name);
            for (double end : {number.least, number.most}) {
                auto text = policy.text(with_number(policy, i, end));
                CHECK(text.starts_with(noun.printed(text)));
            }
            CHECK_THROWS_AS(noun.printed(policy.text(with_number(policy, i, number.least - 1))), UserError);
            CHECK_THROWS_AS(noun.printed(policy.text(with_number(policy, i, number.most + 1))), UserError);
        }
    });
}

TEST_CASE("every noun and policy has a description, and every policy has a source") {
    std::set<std::string> nouns, policies;
    for (const Noun& noun : policy_nouns()) {
        CHECK(nouns.insert(noun.name).second);
        CHECK_FALSE(noun.about.empty());
    }
    for_each_policy([&](const Noun& noun, const PolicyDescription& policy) {
        CAPTURE(noun.name + ": " + policy.name);
        CHECK_FALSE(policy.about.empty());
        CHECK_FALSE(policy.source.empty());
        for (const PolicyNumberDescription& number : policy.numbers)
            CHECK_FALSE(number.about.empty());
        CHECK(nouns.count(policy.name) == 0);
        CHECK(policies.insert(noun.name + "/" + policy.name).second);
    });
}

TEST_CASE("every noun has policies or forms, and every form has a description and a source") {
    std::size_t forms = 0;
    for (const Noun& noun : policy_nouns()) {
        CAPTURE(noun.name);
        CHECK(noun.policies.size() + noun.forms.size() > 0);
        std::set<std::string> names;
        for (const PolicyDescription& policy : noun.policies)
            names.insert(policy.name);
        for (const Form& form : noun.forms) {
            CHECK(names.insert(form.name).second);
            CHECK_FALSE(form.about.empty());
            CHECK_FALSE(form.source.empty());
            CHECK_FALSE(form.example.empty());
        }
        forms += noun.forms.size();
    }
    CHECK(forms == 15); // a form whose noun does not exist would be missing
}

TEST_CASE("policy_nouns() returns all nouns") {
    std::set<std::string> names;
    for (const Noun& noun : policy_nouns())
        names.insert(noun.name);
    for (const char* name :
         {"representation", "selection", "crossover", "mutation", "elitism", "initial-population", "fitness", "window",
          "topology", "schedule", "emigration", "acceptance", "farm", "distributed-fitness", "choice", "coarse-fine"})
        CHECK_MESSAGE(names.count(name) == 1, name);
}

TEST_CASE("operators state the kinds of strings on which they work") {
    for_each_policy([](const Noun& noun, const PolicyDescription& policy) {
        bool is_operator = noun.name == "crossover" || noun.name == "mutation";
        CHECK(policy.strings.empty() == !is_operator);
        if (policy.name == "order")
            CHECK(policy.strings == std::vector<std::string>{"permutations"});
        if (noun.name == "crossover" && policy.name == "uniform")
            CHECK(policy.strings == std::vector<std::string>{"binary strings", "real vectors"});
    });
}
