#include "gaprocs/policies/crossover.hpp"

#include <stdexcept>
#include <utility>

namespace placedpar {

namespace {

using Vertices = std::set<std::uint64_t>;

std::uint64_t vertex_of(const Genome& genome) { return genome.field(0, genome.size()); }

void add_both(Vertices& vertices, const Genome& a, const Genome& b) {
    vertices.insert(vertex_of(a));
    vertices.insert(vertex_of(b));
}

/// Exchanges the characters from `first` to `end` - 1 between the parents `a` and `b`, and adds the two offspring.
void add_exchanged(Vertices& vertices, Genome a, Genome b, std::size_t first, std::size_t end) {
    swap_leading(a, b, first);
    swap_leading(a, b, end);
    add_both(vertices, a, b);
}

Vertices offspring_by(const OnePointCrossover&, const Genome& a, const Genome& b) {
    Vertices vertices;
    for (std::size_t cut = 1; cut < a.size(); ++cut)
        add_exchanged(vertices, a, b, 0, cut);
    return vertices;
}

Vertices offspring_by(const TwoPointCrossover&, const Genome& a, const Genome& b) {
    Vertices vertices;
    for (std::size_t first = 0; first < a.size(); ++first)
        for (std::size_t second = first + 1; second < a.size(); ++second)
            add_exchanged(vertices, a, b, first, second);
    return vertices;
}

Vertices offspring_by(const UniformCrossover&, const Genome& a, const Genome& b) {
    Vertices vertices;
    for (std::uint64_t exchanged = 0; exchanged < std::uint64_t{1} << a.size(); ++exchanged) {
        Genome mask(a.size()), first = a, second = b;
        mask.set_field(0, mask.size(), exchanged);
        swap_where(first, second, mask);
        add_both(vertices, first, second);
    }
    return vertices;
}

Vertices offspring_by(const DifferenceCrossover&, const Genome& a, const Genome& b) {
    Vertices vertices;
    if (difference(a, b) >= 2)
        for (std::size_t cut = first_difference(a, b) + 1; cut <= last_difference(a, b); ++cut)
            add_exchanged(vertices, a, b, 0, cut);
    return vertices;
}

template <class Operator>
Vertices offspring_by(const Operator&, const Genome&, const Genome&) {
    throw std::invalid_argument("all offspring can be computed only for crossovers of binary strings");
}

} // namespace

std::set<std::uint64_t> Crossover::every_offspring(const Genome& a, const Genome& b) const {
    return std::visit([&](const auto& way) { return offspring_by(way, a, b); }, policy());
}

} // namespace placedpar
