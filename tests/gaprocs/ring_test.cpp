#include "gaprocs/search.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

struct Island {
    Search search;
    std::vector<double> fitness;

    Island(std::initializer_list<const char*> texts, std::vector<double> given)
        : search(genomes(texts), three_strings(), RandomStream(1, "island")), fitness(std::move(given)) {}

    static std::vector<Genome> genomes(std::initializer_list<const char*> texts) {
        std::vector<Genome> all;
        for (const char* text : texts)
            all.push_back(Genome::from_string(text));
        return all;
    }
    static SearchSettings three_strings() {
        SearchSettings settings;
        settings.population = 3;
        return settings;
    }
};

} // namespace

// Three islands form a ring: 0 sends to 1, 1 to 2, 2 to 0. The fitness of a string is its binary number. The exchange
// is:
//
//     island  before          fitness  sends   gets    after           fitness
//     0       0001 0111 0100  1 7 4    0111    0101    0101 0111 0100  5 7 4
//     1       1000 0010 0010  8 2 2    1000    0111    1000 0111 0010  8 7 2   (the first 0010 leaves)
//     2       0011 0101 0000  3 5 0    0101    1000    0011 0101 1000  3 5 8
TEST_CASE("in a ring of three islands, the best strings replace the worst as computed by hand") {
    Island ring[3] = {{{"0001", "0111", "0100"}, {1, 7, 4}},
                      {{"1000", "0010", "0010"}, {8, 2, 2}},
                      {{"0011", "0101", "0000"}, {3, 5, 0}}};
    std::vector<Individual> sent;
    for (Island& island : ring)
        sent.push_back(island.search.emigrants(island.fitness).front());
    CHECK(sent[0] == Individual{Genome::from_string("0111"), 7});
    CHECK(sent[1] == Individual{Genome::from_string("1000"), 8});
    CHECK(sent[2] == Individual{Genome::from_string("0101"), 5});
    for (std::size_t i = 0; i < 3; ++i)
        ring[i].search.accept({&sent[(i + 2) % 3], 1}, ring[i].fitness);

    CHECK(ring[0].search.population() == Island::genomes({"0101", "0111", "0100"}));
    CHECK(ring[0].fitness == std::vector<double>{5, 7, 4});
    CHECK(ring[1].search.population() == Island::genomes({"1000", "0111", "0010"}));
    CHECK(ring[1].fitness == std::vector<double>{8, 7, 2});
    CHECK(ring[2].search.population() == Island::genomes({"0011", "0101", "1000"}));
    CHECK(ring[2].fitness == std::vector<double>{3, 5, 8});

    for (Island& island : ring)
        island.search.next_generation(island.fitness);
    CHECK(ring[0].search.best() == Individual{Genome::from_string("0111"), 7});
    CHECK(ring[2].search.best() == Individual{Genome::from_string("1000"), 8});
}

TEST_CASE("an immigrant is accepted even if it is worse than the worst") {
    Island island({"0011", "0101", "0110"}, {3, 5, 6});
    const Individual immigrant{Genome::from_string("0000"), -9};
    island.search.accept({&immigrant, 1}, island.fitness);
    CHECK(island.search.population() == Island::genomes({"0000", "0101", "0110"}));
    CHECK(island.fitness == std::vector<double>{-9, 5, 6});
}
