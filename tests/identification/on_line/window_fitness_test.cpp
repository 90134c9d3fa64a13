// Tests that fitness remembered for a window equals fitness computed anew, and that all vector widths give equal
// results.

#include "gaprocs/representation/genome.hpp"
#include "hydraulics/circuit/flow_constants.hpp"
#include "identification/on_line/diagnosis.hpp"
#include "identification/on_line/window_fitness.hpp"
#include "runtime/random.hpp"
#include "tests/runtime/each_vector_width.hpp"
#include "transient.hpp"

#include <doctest/doctest.h>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

/// Returns a sample in which flow enters every cylinder, and the pressures rise.
SetSample moving_sample(std::size_t links, RandomStream& random) {
    SetSample sample;
    for (std::size_t i = 0; i < links; ++i)
        sample.push_back({300 + 20 * random.uniform(), 2000 + 1000 * random.uniform(), 60 + 20 * random.uniform(),
                          0.1 + 0.1 * random.uniform(), 0.02 + 0.01 * random.uniform()});
    return sample;
}

std::vector<SetSample> moving_samples(std::size_t links, std::size_t count, RandomStream& random) {
    std::vector<SetSample> samples;
    for (std::size_t i = 0; i < count; ++i)
        samples.push_back(moving_sample(links, random));
    return samples;
}

/// Returns the states of all sets in use.
std::vector<PopulationSet::State> states_after(const DiagnosisSettings& settings) {
    Diagnosis diagnosis("digger", excavator_parameters(Parameters::excavator()), settings, 7);
    diagnosis.change({Configuration::a, LinkSet::all()});
    feed(diagnosis, {Configuration::a, LinkSet::all(), {0.015, 0.0086, 0.02, 0.03}}, 0, 25);
    std::vector<PopulationSet::State> states;
    for (LinkSet set : diagnosis.sets_in_use())
        states.push_back(diagnosis.sets().at(set).state());
    return states;
}

} // namespace

TEST_CASE("known strings keep their fitness in every vector width") {
    RandomStream random(1, "window fitness");
    for (LinkSet links : {LinkSet{Link::boom}, LinkSet{Link::bucket, Link::boom}})
        for (std::size_t bits : {4u, 10u, 12u, 13u}) { // the longest strings are not remembered
            SetProblem problem(Configuration::a, links, fitted_flow_constants(), bits);
            auto window = moving_samples(links.size(), 10, random);
            std::vector<std::vector<Genome>> generations;
            for (int i = 0; i < 5; ++i)
                generations.push_back(random_population(121, problem.bits(), random));
            generations.push_back(generations.front());
            test::in_each_vector_width([&] {
                WindowFitness fitness(problem, window, 400);
                for (const auto& population : generations)
                    CHECK(fitness(population) == problem.fitness(population, problem.prepared(window), 400));
            });
        }
}

TEST_CASE("the answers of population sets do not depend on the vector width") {
    for (const Mutation& mutation : {Mutation(BitMutation{}), Mutation(DistanceMutation{})}) {
        DiagnosisSettings settings;
        settings.search.mutation = mutation;
        const auto expected = states_after(settings);
        CHECK(expected.size() > 1);
        for (const PopulationSet::State& state : expected)
            CHECK(state.generations > 50);
        test::in_each_vector_width([&] { CHECK(states_after(settings) == expected); });
    }
}
