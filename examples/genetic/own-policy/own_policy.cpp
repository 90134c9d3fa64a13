// Policies of our own: a selection, a mutation and a topology, and with them the whole command line for netlists.

#include <placedpar/app/program.hpp>

#include <algorithm>

using namespace placedpar;

struct Truncation {
    static constexpr std::string_view name = "own.truncation", about = "the best `share` become parents, equally often",
                                      source = "H. Mühlenbein and D. Schlierkamp-Voosen, 1993";
    static constexpr bool needs_positive_fitness = false;
    double share = 0.5;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"share", &Truncation::share, 0.01, 1, "of the population"});
    }
    Parents operator()(std::span<const double> fitness, std::size_t count, RandomStream& random) const {
        auto some = static_cast<std::size_t>(share * static_cast<double>(fitness.size()));
        std::vector<std::size_t> best = best_indices(fitness, std::max<std::size_t>(some, 1)), parents(count);
        for (std::size_t& parent : parents)
            parent = best[random.below(static_cast<std::uint32_t>(best.size()))];
        return parents;
    }
};

struct BoundaryMutation {
    static constexpr std::string_view name = "own.boundary", about = "a number becomes an end of its range",
                                      source = "Z. Michalewicz, 1992";
    static constexpr bool fits(StringKind kind) { return kind == StringKind::real; }
    void operator()(Genome& genome, std::size_t place, const Representation& representation,
                    RandomStream& random) const {
        RealRange range = representation.reals().range(place);
        representation.reals().set(genome, place, random.chance(0.5) ? range.low : range.high);
    }
};

struct SkippingTopology {
    static constexpr std::string_view name = "own.skipping", about = "to the island `step` further on, around the ring";
    std::size_t step = 3;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"step", &SkippingTopology::step, 1, 1000, "islands"});
    }
    Neighbours operator()(std::size_t islands) const {
        Neighbours all(islands);
        for (std::size_t i = 0; i < islands; ++i)
            all[i] = {(i + step) % islands};
        return all;
    }
};

int main(int argc, char** argv) {
    return run_program(
        argc, argv, {}, {},
        {Reproduction::add<Truncation>, Mutation::add<BoundaryMutation>, Topology::add<SkippingTopology>});
}
