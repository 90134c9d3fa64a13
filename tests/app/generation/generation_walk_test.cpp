#include "app/generation/generation_walk.hpp"
#include "gaprocs/search.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>

using namespace placedpar;

TEST_CASE("the walk makes the generations of the search, bit for bit") {
    for (const char* function : {"square", "ones", "impulse"})
        for (std::size_t population : {2u, 5u, 6u, 20u}) {
            CAPTURE(function);
            CAPTURE(population);
            WalkSettings settings{.population = population, .function = function, .seed = 7};
            SearchSettings search_settings;
            search_settings.population = population;
            search_settings.mutation_probability = settings.mutation_probability;
            Search search(walk_bits, search_settings, RandomStream(7, "generation"));
            GenerationWalk walk(settings);
            for (int generation = 0; generation < 30; ++generation) {
                WalkedGeneration walked = walk.next();
                REQUIRE(walked.population == search.population());
                search.next_generation(walked.fitness);
                REQUIRE(walked.mutated == search.population());
            }
        }
}

TEST_CASE("the reported random numbers lead to the reported offspring") {
    GenerationWalk walk({.population = 6, .seed = 3});
    for (int generation = 0; generation < 20; ++generation) {
        WalkedGeneration walked = walk.next();
        double sum = 0;
        for (double fitness : walked.fitness)
            sum += fitness;
        for (std::size_t place = 0; place < walked.parents.size(); ++place) {
            double below = 0;
            for (std::size_t i = 0; i < walked.parents[place]; ++i)
                below += walked.fitness[i];
            CHECK(walked.spins[place] * sum >= doctest::Approx(below));
            CHECK(walked.spins[place] * sum <= doctest::Approx(below + walked.fitness[walked.parents[place]]));
        }
        for (std::size_t pair = 0; pair < walked.matings.size(); ++pair) {
            Genome a = walked.reproduced[2 * pair], b = walked.reproduced[2 * pair + 1];
            CHECK(walked.matings[pair].crossed == (walked.matings[pair].drawn < 0.8));
            swap_leading(a, b, walked.matings[pair].cut);
            CHECK(a == walked.crossed[2 * pair]);
            CHECK(b == walked.crossed[2 * pair + 1]);
        }
    }
}

TEST_CASE("the text has every string and every schema, and four frames are drawn") {
    WalkSettings settings{.seed = 5};
    WalkedGeneration walked = GenerationWalk(settings).next();
    std::string text = print_walk(walked, settings);
    for (const Genome& genome : walked.population)
        CHECK(text.find(genome.to_string()) != std::string::npos);
    for (const char* schema : {"1***", "*0**", "***1"})
        CHECK(text.find(schema) != std::string::npos);
    auto cubes = draw_walk(walked);
    CHECK(cubes.size() == 4);
    std::string svg = draw_hypercubes("steps", cubes, 2, walk_legend());
    CHECK(svg == draw_hypercubes("steps", cubes, 2, walk_legend()));
    for (const char* words : {"step #0", "step #3", "parents and offspring", "</svg>"})
        CHECK(svg.find(words) != std::string::npos);
}

TEST_CASE("a hypercube that cannot be drawn and impossible walk settings are refused") {
    CHECK_THROWS_AS(draw_hypercubes("", {{.title = "", .dimensions = 5}}, 1, {}), std::invalid_argument);
    CHECK_THROWS_AS(GenerationWalk({.population = 1}), UserError);
    CHECK_THROWS_AS(GenerationWalk({.mutation_probability = 2}), UserError);
    CHECK_THROWS_AS(GenerationWalk({.function = "cube"}), UserError);
}
