#include "gaprocs/fitness.hpp"
#include "gaprocs/representation/genome.hpp"
#include "hydraulics/data/parameters.hpp"
#include "identification/on_line/population_sets.hpp"
#include "identification/on_line/set_problem.hpp"
#include "runtime/random.hpp"
#include "transient.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

constexpr std::size_t bits = 10;

/// Makes the string of these codes in reflected Gray code: the strings of n - 1 and n differ in one bit.
Genome string_of(const std::vector<std::uint64_t>& codes) {
    Genome genome(bits * codes.size());
    for (std::size_t i = 0; i < codes.size(); ++i)
        genome.set_field(i * bits, bits, codes[i] ^ (codes[i] >> 1));
    return genome;
}

SetSample random_set_sample(std::size_t links, RandomStream& random) {
    SetSample sample;
    for (std::size_t i = 0; i < links; ++i)
        sample.push_back({1000 + 1000 * random.uniform(), 3000 * random.uniform() - 1500, 100 * random.uniform() - 20,
                          0.01 + 0.2 * random.uniform(), 0.3 * random.uniform()});
    return sample;
}

} // namespace

TEST_CASE("neighbours in compliance are neighbours in the string") {
    SetProblem problem(Configuration::a, {Link::boom}, fitted_flow_constants(), bits);
    CHECK(problem.bits() == 10);
    for (std::uint64_t code = 0; code < 1024; ++code)
        CHECK(problem.compliance_in3_per_psi(string_of({code}), 0) ==
              doctest::Approx(0.1 * static_cast<double>(code) / 1024));
}

TEST_CASE("fitness agrees with the circuit's error for any order of junctions") {
    RandomStream random(1, "set problem");
    for (Configuration configuration : all_configurations)
        for (LinkSet group : coupled_groups(configuration)) {
            std::vector<Link> links = links_of(group);
            SetProblem problem(configuration, group, fitted_flow_constants(), bits);
            Circuit circuit = circuit_of(configuration, group);
            std::vector<SetSample> window{random_set_sample(links.size(), random),
                                          random_set_sample(links.size(), random)};
            // 19 is not a multiple of a vector's width.
            std::vector<Genome> strings = random_population(19, problem.bits(), random);
            std::vector<double> fitness = problem.fitness(strings, problem.prepared(window), 400);
            for (std::size_t i = 0; i < strings.size(); ++i) {
                double sum = 0;
                for (const SetSample& sample : window) {
                    std::vector<double> compliances;
                    std::vector<LinkSample> samples;
                    for (const Junction& junction : circuit) {
                        auto at = static_cast<std::size_t>(std::ranges::find(links, junction.link) - links.begin());
                        compliances.push_back(problem.compliance_in3_per_psi(strings[i], at));
                        samples.push_back(sample[at]);
                    }
                    sum += fitness_term(400,
                                        circuit_error_in3_per_s<double>(circuit, compliances, samples,
                                                                        fitted_flow_constants(), InletFlow::as_signed));
                }
                CHECK(fitness[i] == sum);
            }
        }
}

TEST_CASE("a path is open if the pump can exceed the cylinder's pressure") {
    SetProblem problem(Configuration::a, {Link::boom}, {100, 175, 25, 4500}, bits);
    // All of 175 in^3/s flows through .068 in^2: 25 + (175 / 6.8)^2 = 687.3 psi.
    CHECK(problem.open({{687, 0, 0, 0.1, 0.068}}));
    CHECK_FALSE(problem.open({{688, 0, 0, 0.1, 0.068}}));
    CHECK_FALSE(problem.open({{600, 0, 0, 0, 0.068}})); // the inlet is shut
    CHECK(problem.open({{4000, 0, 0, 0.1, 0}}));        // the bypass is shut
    // In series, links at 2000 and 1700 psi with these areas take 56.7 and 52.2 in^3/s, at 2032 and 1730 psi.
    SetProblem series(Configuration::a, {Link::bucket, Link::boom}, {100, 175, 25, 4500}, bits);
    CHECK(series.open({{2000, 0, 0, 0.1, 0.068}, {1700, 0, 0, 0.096, 0.016}}));
    CHECK_FALSE(series.open({{2000, 0, 0, 0.1, 0.068}, {2500, 0, 0, 0.096, 0.016}}));
    // The flow that the boom does not take holds the bucket's junction at 993.6 psi or less: it passes .068 and .1 in^2
    // in series.
    CHECK_FALSE(series.open({{994, 0, 0, 0.1, 0.1}, {600, 0, 0, 0.1, 0.068}}));
}

TEST_CASE("the transients of the tests satisfy the equations exactly") {
    PerLink<double> c{0.015, 0.0086, 0.02, 0.03};
    for (Configuration configuration : all_configurations) {
        Diagnosis diagnosis("m", excavator_parameters(Parameters::excavator()), {}, 1);
        diagnosis.change({configuration, LinkSet::all()});
        feed(diagnosis, {configuration, LinkSet::all(), c}, 0, 12);
        for (LinkSet set : diagnosis.sets_in_use()) {
            SetProblem problem(configuration, set, fitted_flow_constants(), 16);
            std::vector<std::uint64_t> codes;
            Genome genome(16 * set.size());
            std::size_t i = 0;
            for (Link link : links_of(set)) {
                auto code = static_cast<std::uint64_t>(std::lround(c[index_of(link)] / 0.1 * 65536));
                genome.set_field(16 * i++, 16, code ^ (code >> 1));
            }
            std::vector<SetSample> window = diagnosis.sets().at(set).state().window;
            CHECK(problem.fitness({&genome, 1}, problem.prepared(window), 400).front() ==
                  doctest::Approx(400.0 * static_cast<double>(window.size())).epsilon(1e-4));
        }
    }
}
