// Tests policies that a program adds for every step: found by name, listed, checked, and as good as PlacedPar's own.

#include "explore/problems.hpp"
#include "gaprocs/islands.hpp"
#include "gaprocs/objective_problem.hpp"
#include "gaprocs/policies/initial_population.hpp"
#include "gaprocs/policies/island_choice.hpp"
#include "gaprocs/usual_settings.hpp"
#include "report/policies_report.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

using namespace placedpar;

namespace {

/// A policy of PlacedPar under another name; results must be equal to those of the original.
template <class Policy, int number>
struct Renamed : Policy {
    static constexpr std::string_view name = number == 0   ? "own.tournament"
                                             : number == 1 ? "own.one-point"
                                             : number == 2 ? "own.swap"
                                             : number == 3 ? "own.ring"
                                             : number == 4 ? "own.sequential"
                                             : number == 5 ? "own.best"
                                             : number == 6 ? "own.worst"
                                                           : "own.choice";
};
using OwnTournament = Renamed<TournamentReproduction, 0>;

struct OnePoint : Renamed<OnePointCrossover, 1> {
    void operator()(Genome& a, Genome& b, const Representation& representation, RandomStream& random) const {
        OnePointCrossover()(a, b, random, representation.unit());
    }
};

struct NumberedRing : Renamed<RingTopology, 3> {
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"ways", &NumberedRing::ways, 1, 2, "1 or 2"}); }
};

struct Lowest {
    static constexpr std::string_view name = "own.lowest", about = "every number at the lower end of its range";
    std::size_t several = 1;
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"several", &Lowest::several, 1, 1000}); }
    std::vector<Genome> operator()(std::size_t, const Representation& representation, RandomStream&) const {
        return std::vector<Genome>(several, Genome(representation.bits()));
    }
};

/// A policy that gives one of several wrong results.
struct Wrong {
    static constexpr std::string_view name = "own.wrong", about = "gives what cannot be used";
    static constexpr bool needs_positive_fitness = false;
    static constexpr bool fits(StringKind) { return true; }
    std::size_t every = 1, count = 1, way = 0;
    static constexpr auto numbers() {
        return std::tuple(PolicyNumber{"every", &Wrong::every, 1, 10}, PolicyNumber{"way", &Wrong::way, 0, 2});
    }
    void may_throw() const {
        if (way == 1)
            throw std::runtime_error("worn out");
        if (way == 2)
            throw 42;
    }
    Parents operator()(std::span<const double> fitness, std::size_t parents, RandomStream&) const {
        may_throw();
        return std::vector<std::size_t>(parents, fitness.size());
    }
    void operator()(Genome& a, Genome&, const Representation&, RandomStream&) const {
        may_throw();
        a = Genome(1);
    }
    void operator()(Genome& genome, std::size_t, const Representation&, RandomStream&) const {
        may_throw();
        genome = Genome(1);
    }
    Neighbours operator()(std::size_t islands) const {
        may_throw();
        return Neighbours(islands, {islands});
    }
    std::span<const std::size_t> operator()(std::uint64_t, std::span<const std::size_t>) const {
        static constexpr std::size_t elsewhere = 0;
        may_throw();
        return {&elsewhere, 1};
    }
    std::vector<std::size_t> operator()(std::span<const double> fitness, RandomStream&) const {
        may_throw();
        return {fitness.size()};
    }
    Places operator()(const IslandPopulation& island, std::span<const Individual> immigrants, RandomStream&) const {
        may_throw();
        return Places(immigrants.size(), island.strings.size());
    }
    std::size_t operator()(const ErrorsOfBest& bests, RandomStream&) const {
        may_throw();
        return bests.windows.size();
    }
    std::vector<Genome> operator()(std::size_t, const Representation&, RandomStream&) const {
        may_throw();
        return {Genome(1)};
    }
};

struct Sphere {
    ParameterCoding representation() const { return ParameterCoding(3, {-5.12, 5.12, 16}); }
    double objective(std::span<const double> x) const { return x[0] * x[0] + x[1] * x[1] + x[2] * x[2]; }
};

/// Adds all policies, once for all tests, since a name cannot be removed.
void add_all() {
    static const bool added = [] {
        Reproduction::add<OwnTournament>();
        Crossover::add<OnePoint>();
        Mutation::add<Renamed<SwapMutation, 2>>();
        Topology::add<NumberedRing>();
        Schedule::add<Renamed<SequentialSchedule, 4>>();
        Emigration::add<Renamed<BestEmigration, 5>>();
        Acceptance::add<Renamed<WorstAcceptance, 6>>();
        IslandChoice::add<Renamed<MeansChoice, 7>>();
        InitialPopulation::add<Lowest>();
        return true;
    }();
    REQUIRE(added);
}

std::vector<std::vector<double>> found_by(std::string_view reproduction, std::string_view crossover,
                                          std::string_view topology, std::string_view schedule,
                                          std::string_view emigration, std::string_view acceptance) {
    auto problem = minimise(Sphere{});
    IslandsSettings settings;
    settings.islands.assign(4, usual_settings(*problem));
    for (SearchSettings& island : settings.islands) {
        island.population = 20;
        island.reproduction = Reproduction::named(reproduction);
        island.crossover = Crossover::named(crossover);
    }
    settings.topology = Topology::named(topology);
    settings.schedule = Schedule::named(schedule);
    settings.emigration = Emigration::named(emigration);
    settings.acceptance = Acceptance::named(acceptance);
    std::vector<std::vector<double>> found;
    for (const SearchResult& island : run_islands(*problem, 30, settings, island_streams(7, 4)).islands)
        for (const auto& each : island.estimates)
            found.push_back(problem->decode(each.best.genome));
    return found;
}

template <class Work>
std::string refusal_of(Work work) {
    try {
        work();
    } catch (const UserError& refused) {
        return refused.what();
    }
    return "";
}

} // namespace

TEST_CASE("a search with own policies is the search with those of the house that do the same") {
    add_all();
    CHECK(found_by("tournament(3)", "one-point", "ring(2)", "sequential(2)", "best(2)", "worst") ==
          found_by("own.tournament(3)", "own.one-point", "own.ring(ways = 2)", "own.sequential(2)", "own.best(2)",
                   "own.worst"));
    CHECK(found_by("tournament(3)", "one-point", "ring(2)", "sequential(2)", "best(2)", "worst") !=
          found_by("own.tournament(4)", "own.one-point", "own.ring(ways = 2)", "own.sequential(2)", "own.best(2)",
                   "own.worst"));
}

TEST_CASE("own policies are listed and described as those of the house") {
    add_all();
    ProblemRegistry problems = known_problems(0);
    Catalogue kinds = known_kinds(problems);
    const std::string all = print_policies();
    for (const char* name :
         {"own.tournament(size = 2)", "own.one-point", "own.swap", "own.ring(ways = 1)", "own.sequential(every = 3)",
          "own.best(count = 1)", "own.worst(only_if_better = 0)", "own.choice", "own.lowest(several = 1)"}) {
        CAPTURE(name);
        CHECK(all.find(name) != all.npos);
        CHECK(is_policy(kinds, name));
    }
    CHECK(print_policy(kinds, "own.ring").find("1 or 2") != std::string::npos);
    CHECK(print_policy(kinds, "own.lowest").find("source: this program") != std::string::npos);
    CHECK(print_policy(kinds, "own.one-point").find("of binary strings, real vectors") != std::string::npos);
    CHECK(Mutation::fitting(StringKind::permutation) == std::vector<std::string>{"swap", "inversion", "own.swap"});
}

TEST_CASE("a wrong name or number is refused as of those of the house") {
    add_all();
    CHECK(refusal_of([] { Reproduction::named("own.tournamnet"); }).ends_with("did you mean \"own.tournament\"?"));
    CHECK(refusal_of([] { Reproduction::named("own.tournament(0)"); }) ==
          "size = 0 is out of range: size is a whole number from 1 to 1000000");
    CHECK(refusal_of([] { Topology::named("own.ring(way = 1)"); }).starts_with("own.ring has no number \"way\""));
    SearchSettings settings;
    OwnTournament none;
    none.size = 0; // built directly as a struct, without any check
    settings.reproduction = OwnReproduction(none);
    CHECK(refusal_of([&] { settings.validate(); }).starts_with("size = 0 is out of range"));
}

namespace {

struct Taken {
    static constexpr std::string_view name = "ring", about = "";
    Neighbours operator()(std::size_t islands) const { return Neighbours(islands); }
};
struct Loud {
    static constexpr std::string_view name = "Loud", about = "";
    Neighbours operator()(std::size_t islands) const { return Neighbours(islands); }
};
struct Unset {
    static constexpr std::string_view name = "own.unset", about = "";
    double share = 0;
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"share", &Unset::share, 0.1, 1}); }
    Neighbours operator()(std::size_t islands) const { return Neighbours(islands); }
};

/// Replaces the individual at `place`.
struct FixedPlace {
    static constexpr std::string_view name = "own.fixed", about = "replaces the individual at one place";
    std::size_t place = 0;
    static constexpr auto numbers() { return std::tuple(PolicyNumber{"place", &FixedPlace::place, 0, 10}); }
    Places operator()(const IslandPopulation&, std::span<const Individual>, RandomStream&) const { return {place}; }
};

} // namespace

TEST_CASE("a policy that cannot be added is refused with the reason") {
    add_all();
    CHECK(refusal_of([] { Topology::add<Taken>(); }) == "this program adds a policy \"ring\" for topology, but this "
                                                        "name is taken: choose another name, such as \"own.ring\"");
    CHECK(refusal_of([] { Topology::add<NumberedRing>(); }).find("this name is taken") != std::string::npos);
    CHECK(refusal_of([] {
              Topology::add<Loud>();
          }).ends_with("but a name may contain only a to z, 0 to 9, \".\" and \"-\""));
    CHECK(refusal_of([] { Topology::add<Unset>(); }).find("but share = 0 is out of range") != std::string::npos);
}

TEST_CASE("an acceptance of the user replaces what the house policies may replace, also among equals") {
    const std::vector<double> fitness{2, 2, 2, 1};
    const std::vector<Genome> strings(4, Genome(8));
    const std::vector<Individual> immigrants{{Genome(8), 5}};
    const IslandPopulation island{.strings = strings, .fitness = fitness, .elite = 1};
    RandomStream random(1, "equals");
    for (std::size_t place : {0U, 1U, 3U}) // the elite is the last of the equals
        CHECK(OwnAcceptance{FixedPlace{place}}(island, immigrants, random).front() == place);
    CHECK(refusal_of([&] { OwnAcceptance{FixedPlace{2}}(island, immigrants, random); }) != "");
}

TEST_CASE("what a policy throws, or gives that cannot be used, is refused by its name") {
    const std::vector<double> fitness{1, 2, 3};
    const std::vector<std::size_t> neighbours{1, 2};
    const Representation bits = BitString(8);
    std::vector<Genome> strings(3, Genome(8));
    const std::vector<Individual> immigrants{{Genome(8), 5}};
    RandomStream random(1, "wrong");
    for (std::size_t way : {0U, 1U, 2U}) {
        Wrong wrong{.way = way};
        const std::string begins = "the policy \"own.wrong(every = 1, way = " + std::to_string(way) + ")\": ";
        const std::string ends = way == 0 ? "" : way == 1 ? "worn out" : "an exception that is not a std::exception";
        for (const std::string& why :
             {refusal_of([&] { OwnReproduction{wrong}(fitness, 2, random); }),
              refusal_of([&] { OwnCrossover{wrong}(strings, 1, bits, random); }),
              refusal_of([&] { OwnMutation{wrong}(strings, 1, bits, random); }),
              refusal_of([&] { OwnTopology{wrong}(3); }), refusal_of([&] { OwnSchedule{wrong}(1, neighbours); }),
              refusal_of([&] { OwnEmigration{wrong}(fitness, random); }), refusal_of([&] {
                  OwnAcceptance{wrong}({strings, fitness}, immigrants, random);
              }),
              refusal_of([&] {
                  OwnChoice{wrong}({{2, 3}, {}}, random);
              }),
              refusal_of([&] { OwnStart{wrong}(3, bits, random); })}) {
            CHECK(why.starts_with(begins));
            CHECK(why.ends_with(ends));
        }
    }
}

namespace {

/// Throws when no copies are left.
struct Fragile {
    static constexpr std::string_view name = "own.fragile", about = "throws when it is copied";
    static inline int copies_left = 1000;
    Fragile() = default;
    Fragile(const Fragile&) {
        if (copies_left-- <= 0)
            throw "worn out";
    }
    Neighbours operator()(std::size_t islands) const { return Neighbours(islands); }
};

} // namespace

TEST_CASE("what a policy throws while it is copied is refused by its name") {
    Topology::add<Fragile>();
    const Topology whole = Topology::named("own.fragile");
    CHECK(Topology(whole).text() == "own.fragile");
    Fragile::copies_left = 0;
    CHECK(refusal_of([&] { Topology copy(whole); }) == "the policy \"own.fragile\": worn out");
    CHECK(refusal_of([&] { Topology().operator=(whole); }) == "the policy \"own.fragile\": worn out");
    CHECK(refusal_of([] { Topology::named("own.fragile"); }) == "the policy \"own.fragile\" for topology: worn out");
    Fragile::copies_left = 1000;
}

TEST_CASE("a permutation of one place stays, and an own mutation is not asked") {
    RandomStream random(1, "one place"), untouched(1, "one place");
    std::vector<Genome> population{Permutation(1).encode(std::vector<std::size_t>{0})};
    Mutation(OwnMutation(Wrong{.way = 1}))(population, 1, Permutation(1), random);
    CHECK(random.uniform() == untouched.uniform());
}

TEST_CASE("an offspring that is not a string of the problem is refused") {
    const Permutation order(3);
    const std::vector<std::size_t> twice{0, 1, 1};
    CHECK_FALSE(Representation(order).holds(std::vector<Genome>{order.encode(twice)}));
    CHECK(Representation(order).holds(std::vector<Genome>{order.encode(std::vector<std::size_t>{2, 0, 1})}));
    const RealVector narrow(1, {0, 1}), wide(1, {0, 9});
    Genome beyond(64);
    wide.set(beyond, 0, 5);
    CHECK(Representation(wide).holds(std::vector<Genome>{beyond}));
    CHECK_FALSE(Representation(narrow).holds(std::vector<Genome>{beyond}));
}
