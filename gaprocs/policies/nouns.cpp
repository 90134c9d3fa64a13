#include "gaprocs/policies/nouns.hpp"

#include "gaprocs/policies/acceptance.hpp"
#include "gaprocs/policies/coding.hpp"
#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/emigration.hpp"
#include "gaprocs/policies/island_choice.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "gaprocs/policies/reproduction.hpp"
#include "gaprocs/policies/schedule.hpp"
#include "gaprocs/policies/topology.hpp"

#include <algorithm>

namespace placedpar {

namespace {

template <class Step>
Noun noun_of() {
    return {.name = std::string(Step::noun),
            .about = std::string(Step::about),
            .policies = Step::descriptions(),
            .printed = [](const std::string& text) { return Step::named(text).text(); }};
}

/// Of an operator: each policy says on which strings it can work.
template <class Step>
Noun noun_of_operator() {
    Noun noun = noun_of<Step>();
    for (StringKind kind : {StringKind::binary, StringKind::real, StringKind::permutation})
        for (const std::string& name : Step::fitting(kind))
            std::ranges::find(noun.policies, name, &PolicyDescription::name)->strings.emplace_back(name_of(kind));
    return noun;
}

} // namespace

std::vector<Noun> policy_nouns() {
    return {noun_of<Coding>(),
            {.name = "initial-population", .about = "where a search begins: at random, or with strings of a file"},
            noun_of<Reproduction>(),
            noun_of_operator<Crossover>(),
            noun_of_operator<Mutation>(),
            {.name = "elitism", .about = "how many of the best go over unchanged (thesis: none)"},
            noun_of<Topology>(),
            noun_of<Schedule>(),
            noun_of<Emigration>(),
            noun_of<Acceptance>(),
            noun_of<IslandChoice>(),
            {.name = "farm", .about = "how a master deals its population out to slaves (thesis, algorithm A)"}};
}

} // namespace placedpar
