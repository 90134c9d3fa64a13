#include "gaprocs/representation/strings_in_lanes.hpp"

#include "gaprocs/representation/coding.hpp"
#include "gaprocs/representation/parameter_coding.hpp"
#include "gaprocs/search_problem.hpp"
#include "runtime/random.hpp"
#include "tests/runtime/each_vector_width.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

using namespace placedpar;

namespace {

/// Returns each parameter of each individual, decoded in lanes.
template <bool gray>
std::vector<double> values_in_lanes(const ParameterCoding& coding, std::span<const Genome> population) {
    std::vector<double> values;
    in_vectors([&]<std::size_t width>() {
        for (std::size_t first = 0; first < population.size(); first += Lanes<width>::count) {
            StringsInLanes<width, gray> strings(population, first);
            for (std::size_t i = 0; i < coding.parameters(); ++i) {
                auto found = coding.value(strings, i).numbers();
                values.insert(values.end(), found.begin(), found.end());
            }
        }
    });
    return values;
}

template <bool gray>
std::vector<double> values_one_by_one(const ParameterCoding& coding, std::span<const Genome> population) {
    using Read = std::conditional_t<gray, GrayCoded<Genome>, const Genome&>;
    constexpr std::size_t lanes = 8;
    std::vector<double> values;
    for (std::size_t first = 0; first < population.size(); first += lanes)
        for (std::size_t i = 0; i < coding.parameters(); ++i)
            for (std::size_t lane = first; lane < first + lanes; ++lane)
                values.push_back(coding.value(Read(population[std::min(lane, population.size() - 1)]), i));
    return values;
}

/// A problem that decodes several strings at once.
struct ManyBits {
    ParameterCoding coding;

    std::size_t bits() const { return coding.bits(); }
    std::size_t channels() const { return 1; }
    template <BinaryString G>
    std::vector<double> decode(const G& genome) const {
        return coding.decode(genome);
    }
    template <BinaryString G>
    std::vector<double> parameters_of(const G& genome) const {
        return decode(genome);
    }
    template <std::size_t width, bool gray>
    std::vector<Lanes<width>> parameters_of_several(const StringsInLanes<width, gray>& strings) const {
        std::vector<Lanes<width>> parameters;
        for (std::size_t i = 0; i < coding.parameters(); ++i)
            parameters.push_back(coding.value(strings, i));
        return parameters;
    }
    template <typename T>
    T error_of(std::span<const T> parameters, std::span<const double> sample) const {
        T sum = 0.0;
        for (const T& each : parameters)
            sum += each * sample[0];
        return sum;
    }
    template <BinaryString G>
    double error(const G& genome, std::span<const double> sample) const {
        return error_of<double>(decode(genome), sample);
    }
    std::vector<std::string> parameter_names() const { return std::vector<std::string>(coding.parameters(), "x"); }
    std::vector<std::string> parameter_units() const { return std::vector<std::string>(coding.parameters()); }
};

} // namespace

TEST_CASE("a problem that decodes several strings at once gives the fitness of each string, whatever its length") {
    const std::vector<Sample> samples{{1}, {-.5}, {3}};
    RandomStream random(2, "strings");
    for (std::size_t parameters : {1u, 12u, 13u, 40u}) // 20 to 800 bits; up to 256 bits fit into lanes
        for (Coding coding : {Coding::natural, Coding::gray}) {
            auto problem = make_search_problem(ManyBits{{parameters, {-1, 1, 20}}}, coding);
            auto population = random_population(11, problem->bits(), random);
            std::vector<double> fitness(population.size());
            problem->fitness_of(population, samples, 100, fitness);
            for (std::size_t i = 0; i < population.size(); ++i)
                CHECK(fitness[i] == problem->fitness(population[i], samples, 100));
        }
}

TEST_CASE("strings in lanes are read as single strings are, in both codings") {
    const ParameterField delay{1, 5, 2}, part{-1, 1, 7}, whole{-3, 90, 11, true}, finest{0, 1, 52};
    const std::vector<std::vector<ParameterField>> codings{{delay, part, part, part, part, {0, 2, 7}},
                                                           {finest, whole, finest},
                                                           {{0, .1, 64 - 52}, finest, whole},
                                                           {part},
                                                           {finest, finest, finest, finest, {5, 6, 48}}};
    RandomStream random(1, "strings");
    for (const auto& fields : codings) {
        ParameterCoding coding(fields);
        CAPTURE(coding.bits());
        for (std::size_t individuals : {1u, 7u, 8u, 9u, 24u}) {
            auto population = random_population(individuals, coding.bits(), random);
            population.front() = Genome::from_string(std::string(coding.bits(), '1'));
            test::in_each_vector_width([&] {
                CHECK(values_in_lanes<false>(coding, population) == values_one_by_one<false>(coding, population));
                CHECK(values_in_lanes<true>(coding, population) == values_one_by_one<true>(coding, population));
            });
        }
    }
}
