#include "gaprocs/search.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;

namespace {

using Texts = std::vector<std::string>;

Texts texts_of(const Search& search) {
    Texts texts;
    for (const Genome& genome : search.population())
        texts.push_back(genome.to_string());
    return texts;
}

/// Returns a fitness that is positive if there are more ones than zeros.
double more_ones(const std::string& text) {
    double sum = 0;
    for (char c : text)
        sum += c == '1' ? 1.25 : -1;
    return sum;
}

std::vector<double> fitness_of(const Texts& population) {
    std::vector<double> fitness;
    for (const std::string& text : population)
        fitness.push_back(more_ones(text));
    return fitness;
}

SearchSettings small(std::size_t population) {
    SearchSettings settings;
    settings.population = population;
    return settings;
}

/// Implements the algorithm as simply as possible, on strings of text. Draws random numbers in the same order as
/// Search.
struct PlainSearch {
    RandomStream random;
    std::size_t bits;
    Texts population;
    std::size_t elite = 0;
    bool universal = false;

    Texts draw(std::size_t count) {
        Texts drawn(count);
        for (std::string& text : drawn) {
            std::uint32_t number = 0;
            for (std::size_t i = 0; i < bits; ++i) {
                if (i % 32 == 0)
                    number = random();
                text += (number >> (31 - i % 32)) & 1u ? '1' : '0';
            }
        }
        return drawn;
    }

    void next_generation() {
        Texts ranked = population;
        std::stable_sort(ranked.begin(), ranked.end(),
                         [](const std::string& a, const std::string& b) { return more_ones(a) > more_ones(b); });
        ranked.resize(elite);
        Texts offspring = breed(population.size() - elite);
        population = ranked;
        population.insert(population.end(), offspring.begin(), offspring.end());
    }

    Texts breed(std::size_t count) {
        double total = 0;
        for (const std::string& text : population)
            total += std::max(more_ones(text), 0.0);
        if (total == 0)
            return draw(count);
        Texts offspring = universal ? spin_once(count, total) : Texts{};
        while (offspring.size() < count)
            offspring.push_back(spin(random.uniform() * total));
        for (std::size_t i = 0; i + 1 < offspring.size(); i += 2)
            if (bits > 1 && random.uniform() < 0.8) {
                std::size_t cut = 1 + random.below(static_cast<std::uint32_t>(bits - 1));
                for (std::size_t c = 0; c < cut; ++c)
                    std::swap(offspring[i][c], offspring[i + 1][c]);
            }
        for (std::string& text : offspring)
            for (char& c : text)
                if (random.uniform() < 0.01)
                    c = c == '0' ? '1' : '0';
        return offspring;
    }

    Texts spin_once(std::size_t count, double total) {
        double turn = random.uniform();
        Texts parents;
        for (std::size_t i = 0; i < count; ++i)
            parents.push_back(spin((static_cast<double>(i) + turn) / static_cast<double>(count) * total));
        for (std::size_t left = count; left > 1; --left)
            std::swap(parents[left - 1], parents[random.below(static_cast<std::uint32_t>(left))]);
        return parents;
    }

    const std::string& spin(double ball) const {
        double passed = 0;
        for (const std::string& text : population)
            if (passed += std::max(more_ones(text), 0.0); passed > ball)
                return text;
        throw std::logic_error("the ball left the wheel");
    }
};

} // namespace

TEST_CASE("a search has the same populations as a simple implementation, for every size and option") {
    std::uint64_t redraws = 0;
    for (std::size_t bits : {1u, 2u, 3u, 10u, 33u, 64u, 65u, 130u})
        for (std::size_t population : {2u, 3u, 4u, 7u, 30u})
            for (std::size_t elite : {0u, 1u, 2u})
                for (bool universal : {false, true}) {
                    if (elite + 2 > population)
                        continue;
                    CAPTURE(bits);
                    CAPTURE(population);
                    CAPTURE(elite);
                    CAPTURE(universal);
                    RandomStream random(bits, "plain");
                    PlainSearch plain{random, bits, {}, elite, universal};
                    plain.population = plain.draw(population);
                    SearchSettings settings = small(population);
                    settings.elite = elite;
                    settings.reproduction = universal ? Reproduction(UniversalReproduction{}) : Reproduction();
                    Search search(bits, settings, random);
                    for (int generation = 0; generation < 40; ++generation) {
                        REQUIRE(texts_of(search) == plain.population);
                        search.next_generation(fitness_of(plain.population));
                        plain.next_generation();
                    }
                    redraws += search.redraws();
                }
    CHECK(redraws > 0); // some populations were drawn anew
}

TEST_CASE("50 generations of 120 strings of 10 bits have the stored hash") {
    Search search(10, {}, RandomStream(1991, "golden"));
    std::uint64_t hash = 0xcbf29ce484222325u; // FNV-1a of the decoded numbers
    for (int generation = 0; generation < 50; ++generation) {
        std::vector<double> fitness;
        for (const Genome& genome : search.population()) {
            auto code = genome.field(0, 10);
            hash = (hash ^ code) * 0x100000001b3u;
            double miss = (static_cast<double>(code) - 88) / 8;
            fitness.push_back(400 - miss * miss);
        }
        search.next_generation(fitness);
    }
    CHECK(hash == 4296940583145610401u);
    CHECK(std::abs(static_cast<double>(search.best().genome.field(0, 10)) - 88) <= 4);
}

TEST_CASE("best() is the best individual of the last evaluated generation; among equals, the first") {
    Search search({Genome::from_string("00"), Genome::from_string("01"), Genome::from_string("10")}, small(3),
                  RandomStream(1, "best"));
    CHECK_THROWS_AS(search.best(), std::logic_error);
    search.next_generation(std::array<double, 3>{1, 5, 5});
    CHECK(search.best() == Individual{Genome::from_string("01"), 5});
    CHECK(search.generation() == 1);
    search.next_generation(std::array<double, 3>{-3, -2, -1});
    CHECK(search.best().fitness == -1);
    CHECK(search.redraws() == 1);
}

TEST_CASE("if no individual has positive fitness, the whole population is drawn anew") {
    Search search(64, small(5), RandomStream(1, "anew"));
    auto before = search.population();
    search.next_generation(std::vector<double>(5, 0.0));
    CHECK(search.redraws() == 1);
    for (std::size_t i = 0; i < 5; ++i)
        CHECK(search.population()[i] != before[i]);
}

TEST_CASE("settings that make no sense are refused with a reason") {
    RandomStream random(1, "refused");
    CHECK_THROWS_WITH_AS(Search(10, small(1), random),
                         "the population is 1, expected at least 2: crossover needs two parents", UserError);
    CHECK_THROWS_WITH_AS(Search(10, small(1'000'001), random), "the population is 1000001, expected at most 1000000",
                         UserError);
    CHECK_THROWS_WITH_AS(Search(0, small(2), random), "the binary string has 0 bits, expected at least 1",
                         std::invalid_argument);
    SearchSettings settings;
    settings.mutation_probability = 1.5;
    CHECK_THROWS_WITH_AS(Search(10, settings, random), "the mutation probability is 1.5, expected 0 to 1", UserError);
    settings = {};
    settings.crossover_probability = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_AS(Search(10, settings, random), UserError);
    CHECK_THROWS_AS(Search({Genome(3), Genome(4)}, small(2), random), std::invalid_argument);
    CHECK_THROWS_AS(Search({Genome(3), Genome(3)}, small(3), random), std::invalid_argument);
}

TEST_CASE("a wrong number of fitness values, an infinite fitness and a longer immigrant are refused") {
    Search search(4, small(3), RandomStream(1, "fit"));
    CHECK_THROWS_WITH_AS(search.next_generation(std::vector<double>(2)),
                         "2 fitness values were given for a population of 3", std::invalid_argument);
    std::vector<double> infinite{1, 2, std::numeric_limits<double>::infinity()};
    CHECK_THROWS_WITH_AS(search.next_generation(infinite),
                         "the fitness of individual 2 is inf, expected a finite number", std::invalid_argument);
    std::vector<double> fitness{1, 2, 3};
    const Individual longer{Genome(5), 1};
    CHECK_THROWS_WITH_AS(search.accept({&longer, 1}, fitness),
                         "an immigrant has 5 bits, but the island's strings have 4 bits", std::invalid_argument);
}

TEST_CASE("a search goes on from a state as if it had not been interrupted") {
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
        Search whole(40, small(10), RandomStream(seed, "search"));
        for (std::size_t generation = 0; generation < 7; ++generation)
            whole.next_generation(fitness_of(texts_of(whole)));
        Search second(40, small(10), RandomStream(seed, "search"));
        second.go_on_from(whole.state());
        CHECK(second.best() == whole.best());
        for (std::size_t generation = 7; generation < 20; ++generation) {
            whole.next_generation(fitness_of(texts_of(whole)));
            second.next_generation(fitness_of(texts_of(second)));
            REQUIRE(texts_of(second) == texts_of(whole));
        }
        CHECK(second.state() == whole.state());
    }
}

TEST_CASE("a state of another search is refused") {
    Search search(40, small(10), RandomStream(1, "search"));
    const SearchState good = search.state();
    SearchState fewer = good, longer = good, endless = good;
    fewer.population.pop_back();
    longer.population.front() = Genome(41);
    endless.best = Individual{Genome(40), std::numeric_limits<double>::infinity()};
    for (const SearchState& bad : {fewer, longer, endless})
        CHECK_THROWS_AS(search.go_on_from(bad), UserError);
    CHECK(search.state() == good);
}
