#include "gaprocs/policies/nouns.hpp"

#include "gaprocs/policies/acceptance.hpp"
#include "gaprocs/policies/coding.hpp"
#include "gaprocs/policies/crossover.hpp"
#include "gaprocs/policies/emigration.hpp"
#include "gaprocs/policies/forms.hpp"
#include "gaprocs/policies/initial_population.hpp"
#include "gaprocs/policies/island_choice.hpp"
#include "gaprocs/policies/mutation.hpp"
#include "gaprocs/policies/reproduction.hpp"
#include "gaprocs/policies/schedule.hpp"
#include "gaprocs/policies/topology.hpp"

#include <algorithm>
#include <utility>

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

/// The same, which is also looked for by other words.
Noun also_called(std::vector<std::string> words, Noun noun) {
    noun.also_called = std::move(words);
    return noun;
}

/// The same, with a way that is no policy.
Noun with_form(Noun noun, Form form) {
    noun.forms.push_back(std::move(form));
    return noun;
}

} // namespace

std::vector<Noun> policy_nouns() {
    return {also_called({"encoding", "genome"}, with_form(noun_of<Coding>(), forms::permutation())),
            also_called({"population"}, with_form(noun_of<InitialPopulation>(), forms::predefined())),
            forms::fitness(),
            forms::window(),
            noun_of<Reproduction>(),
            also_called({"crossover-rate", "operator"}, noun_of_operator<Crossover>()),
            also_called({"mutation-rate", "operator"}, noun_of_operator<Mutation>()),
            forms::elitism(),
            also_called({"migration", "neighbours"}, noun_of<Topology>()),
            also_called({"migration"}, noun_of<Schedule>()),
            also_called({"migration", "emigrants", "migrants"}, noun_of<Emigration>()),
            also_called({"migration", "immigration", "immigrants", "replacement"}, noun_of<Acceptance>()),
            forms::distributed_fitness(),
            also_called({"active-error-analysis", "error-matrix"}, noun_of<IslandChoice>()),
            forms::coarse_fine(),
            forms::farm()};
}

} // namespace placedpar
