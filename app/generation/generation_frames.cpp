#include "app/generation/generation_walk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace placedpar {

namespace {

using Copies = std::map<std::uint32_t, std::size_t>;

std::uint32_t vertex_number(const Genome& genome) { return static_cast<std::uint32_t>(genome.field(0, walk_bits)); }

Copies copies_at(const std::vector<Genome>& strings) {
    Copies copies;
    for (const Genome& genome : strings)
        ++copies[vertex_number(genome)];
    return copies;
}

std::string copies_note(std::size_t copies) { return copies > 1 ? fmt::format("{} copies", copies) : ""; }

std::vector<DrawnVertex> members_at(const Copies& copies) {
    std::vector<DrawnVertex> vertices;
    for (auto [number, count] : copies)
        vertices.push_back({number, VertexLook::member, copies_note(count)});
    return vertices;
}

std::string step_title(const WalkedGeneration& walked, int step, const char* what) {
    return fmt::format("Generation {}, step #{}: {}", walked.number, step, what);
}

DrawnHypercube evaluated_cube(const WalkedGeneration& walked) {
    DrawnHypercube cube{.title = step_title(walked, 0, "the population and its fitness")};
    Copies copies = copies_at(walked.population);
    for (std::size_t i = 0; i < walked.population.size(); ++i) {
        std::uint32_t vertex = vertex_number(walked.population[i]);
        if (std::ranges::find(cube.vertices, vertex, &DrawnVertex::number) != cube.vertices.end())
            continue;
        std::string several = copies[vertex] > 1 ? fmt::format(", {} copies", copies[vertex]) : "";
        cube.vertices.push_back({vertex, VertexLook::member, fmt::format("f = {}{}", walked.fitness[i], several)});
    }
    return cube;
}

DrawnHypercube reproduced_cube(const WalkedGeneration& walked) {
    DrawnHypercube cube{.title = step_title(walked, 1, "after reproduction")};
    Copies after = copies_at(walked.reproduced);
    cube.vertices = members_at(after);
    for (auto [number, count] : copies_at(walked.population))
        if (!after.contains(number))
            cube.vertices.push_back({number, VertexLook::empty, "eliminated"});
    return cube;
}

std::string mating_line(const WalkedGeneration& walked, std::size_t pair) {
    auto text = [](const std::vector<Genome>& strings, std::size_t i) { return strings[i].to_string(); };
    const Mating& mating = walked.matings[pair];
    std::string parents = text(walked.reproduced, 2 * pair) + " and " + text(walked.reproduced, 2 * pair + 1);
    if (!mating.crossed)
        return parents + " are not crossed";
    return fmt::format("{}, cut after {}: {} and {}", parents, mating.cut, text(walked.crossed, 2 * pair),
                       text(walked.crossed, 2 * pair + 1));
}

DrawnHypercube crossed_cube(const WalkedGeneration& walked) {
    DrawnHypercube cube{.title = step_title(walked, 2, "parents and offspring")};
    Copies parents = copies_at(walked.reproduced), offspring = copies_at(walked.crossed);
    for (auto [number, count] : parents)
        cube.vertices.push_back({number, VertexLook::parent});
    for (auto [number, count] : offspring)
        if (!parents.contains(number))
            cube.vertices.push_back({number, VertexLook::offspring});
    for (std::size_t pair = 0; pair < walked.matings.size(); ++pair) {
        if (walked.matings[pair].crossed)
            cube.spanned.emplace_back(vertex_number(walked.reproduced[2 * pair]),
                                      vertex_number(walked.reproduced[2 * pair + 1]));
        cube.lines.push_back(mating_line(walked, pair));
    }
    return cube;
}

DrawnHypercube mutated_cube(const WalkedGeneration& walked) {
    DrawnHypercube cube{.title = step_title(walked, 3, "mutation, and the next population"),
                        .vertices = members_at(copies_at(walked.mutated))};
    for (std::size_t i = 0; i < walked.crossed.size(); ++i)
        if (walked.crossed[i] != walked.mutated[i]) {
            cube.moves.emplace_back(vertex_number(walked.crossed[i]), vertex_number(walked.mutated[i]));
            cube.lines.push_back(walked.crossed[i].to_string() + " becomes " + walked.mutated[i].to_string());
        }
    if (cube.lines.empty())
        cube.lines = {walked.crossed.empty() ? "all strings are drawn at random, because no fitness was positive"
                                             : "no bit was flipped"};
    return cube;
}

} // namespace

std::vector<DrawnHypercube> draw_walk(const WalkedGeneration& walked) {
    if (walked.parents.empty())
        return {evaluated_cube(walked), mutated_cube(walked)};
    return {evaluated_cube(walked), reproduced_cube(walked), crossed_cube(walked), mutated_cube(walked)};
}

VertexLegend walk_legend() {
    return {{VertexLook::member, "in the population"},
            {VertexLook::parent, "parent; thick links: the subcube that two mates span"},
            {VertexLook::offspring, "new offspring"},
            {VertexLook::empty, "no individual"}};
}

} // namespace placedpar
