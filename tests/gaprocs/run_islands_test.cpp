// Tests islands in the library. islands_test.cpp tests them on the simulated machine.

#include "gaprocs/islands.hpp"
#include "tests/gaprocs/cluster.hpp"
#include "tests/sanitized.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

using namespace placedpar;

namespace {

/// A problem whose fitness grows with the 16-bit number in the string. The samples do not matter.
struct GreatestNumber {
    std::size_t bits() const { return 16; }
    std::size_t channels() const { return 1; }
    double error(const Genome& genome, std::span<const double>) const {
        return 20 * (1 - static_cast<double>(genome.field(0, 16)) / 65535);
    }
    std::vector<double> decode(const Genome& genome) const { return {static_cast<double>(genome.field(0, 16))}; }
    std::vector<std::string> parameter_names() const { return {"number"}; }
    std::vector<std::string> parameter_units() const { return {"1"}; }
};

IslandsSettings alike(std::size_t islands, const SearchSettings& each) {
    IslandsSettings settings;
    settings.islands.assign(islands, each);
    return settings;
}

IslandsSettings small_islands(std::size_t islands) {
    SearchSettings each;
    each.population = 12;
    each.elite = 1;
    return alike(islands, each);
}

/// Returns small islands without crossover and mutation, so that only exchanges can spread the best individual.
IslandsSettings barren(std::size_t islands, const char* topology, const char* schedule) {
    SearchSettings each;
    each.population = 12;
    each.elite = 1;
    each.crossover_probability = each.mutation_probability = 0;
    each.window.length = 1;
    IslandsSettings settings = alike(islands, each);
    settings.topology = Topology::named(topology);
    settings.schedule = Schedule::named(schedule);
    return settings;
}

/// Runs islands, one of which begins with an individual that is better than all others.
class Takeover {
public:
    explicit Takeover(const IslandsSettings& settings)
        : problem_(make_search_problem(GreatestNumber{})),
          islands_(*problem_, settings, island_streams(1, settings.islands.size())) {
        islands_.push({0});
        std::size_t equals = 0;
        for (std::size_t i = 0; i < islands_.searches().size(); ++i)
            for (const Genome& genome : islands_.searches()[i].population())
                if (genome.field(0, 16) >= greatest_.field(0, 16)) {
                    equals = genome == greatest_ ? equals + 1 : 0;
                    greatest_ = genome;
                    home_ = i;
                }
        REQUIRE(equals == 0);
    }

    std::size_t home() const { return home_; }
    const Genome& greatest() const { return greatest_; }
    const std::vector<Genome>& population(std::size_t island) const { return islands_.searches()[island].population(); }
    const std::vector<Migration>& migrations() const { return islands_.migrations(); }
    void next_generation() { islands_.next_generation(); }
    bool reached(std::size_t island) const { return islands_.searches()[island].best().genome == greatest_; }
    /// Returns the number of generations until this individual is the best of every island.
    std::size_t generations() {
        std::size_t count = 0;
        for (bool everywhere = false; !everywhere && count < 1000; ++count) {
            next_generation();
            everywhere = true;
            for (std::size_t i = 0; i < islands_.searches().size(); ++i)
                everywhere = everywhere && reached(i);
        }
        return count;
    }

private:
    std::shared_ptr<const SearchProblem> problem_;
    Islands islands_;
    Genome greatest_ = Genome(16);
    std::size_t home_ = 0;
};

std::size_t generations_to_take_over(std::size_t islands, const char* topology, const char* schedule) {
    return Takeover(barren(islands, topology, schedule)).generations();
}

IslandsResult run_on_line_record(const IslandsSettings& settings, std::uint64_t seed = 1) {
    return run_islands(*make_search_problem(LineProblem{}), line_record(line_samples), settings,
                       island_streams(seed, settings.islands.size()));
}

bool same(const SearchResult& a, const SearchResult& b) {
    auto same_estimate = [](const Estimate& one, const Estimate& other) {
        return one.sample == other.sample && one.best == other.best && one.parameters == other.parameters;
    };
    return std::ranges::equal(a.estimates, b.estimates, same_estimate) && a.generations == b.generations &&
           a.redraws == b.redraws && a.population == b.population;
}

bool same(const IslandsResult& a, const IslandsResult& b) {
    auto same_island = [](const SearchResult& one, const SearchResult& other) { return same(one, other); };
    return std::ranges::equal(a.islands, b.islands, same_island) && a.migrations == b.migrations;
}

std::string refusal(const IslandsSettings& settings) {
    try {
        run_on_line_record(settings);
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("without exchange each island has the generations of a traditional search with the island's settings") {
    IslandsSettings settings = small_islands(3);
    settings.topology = NoTopology{};
    settings.islands[1].population = 30;
    settings.islands[2].window.length = 7;
    auto problem = make_search_problem(LineProblem{});
    IslandsResult result = run_on_line_record(settings);
    CHECK(result.migrations.empty());
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(same(result.islands[i],
                   run_traditional(*problem, line_record(line_samples), settings.islands[i], island_streams(1, 3)[i])));
}

TEST_CASE("the best individual spreads as far as exchanges go, and no farther") {
    for (const char* topology : {"ring", "ring(2)", "hypercube", "torus(2)", "star", "complete"}) {
        CAPTURE(topology);
        Takeover takeover(barren(8, topology, "broadcast(1)"));
        auto distance = distances(Topology::named(topology).neighbours(8), takeover.home());
        for (std::size_t generation = 1; generation <= 8; ++generation) {
            takeover.next_generation();
            for (std::size_t i = 0; i < 8; ++i)
                CHECK(takeover.reached(i) == (distance[i].value() <= generation));
        }
    }
}

TEST_CASE(
    "takeover takes n - 1 exchanges around a one-way ring, n / 2 around a two-way ring, and log2 n on a hypercube") {
    for (std::size_t n : {2u, 4u, 8u, 16u}) {
        CHECK(generations_to_take_over(n, "ring", "broadcast(1)") == n - 1);
        CHECK(generations_to_take_over(n, "ring(2)", "broadcast(1)") == n / 2);
        auto dimensions = static_cast<std::size_t>(std::bit_width(n) - 1);
        CHECK(generations_to_take_over(n, "hypercube", "broadcast(1)") == dimensions);
        CHECK(generations_to_take_over(n, "hypercube", "broadcast(5)") == 5 * dimensions);
        // Each exchange goes along another dimension, which doubles the number of islands reached.
        CHECK(generations_to_take_over(n, "hypercube", "sequential(1)") == dimensions);
    }
    CHECK(generations_to_take_over(8, "ring(2)", "sequential(1)") == 7); // each exchange reaches one more island
    CHECK(generations_to_take_over(8, "complete", "broadcast(1)") == 1);
}

TEST_CASE("sequential exchange on four islands goes to i xor 1, then to i xor 2") {
    IslandsSettings settings = small_islands(4);
    settings.topology = HypercubeTopology{};
    settings.schedule = SequentialSchedule{4};
    IslandsResult result = run_on_line_record(settings);
    std::size_t exchanges = result.islands[0].generations / 4;
    REQUIRE(exchanges == 10); // 8 of 12 samples, from the fifth on, with 5 generations each
    REQUIRE(result.migrations.size() == 4 * exchanges);
    for (std::size_t m = 0; m < result.migrations.size(); ++m) {
        const Migration& migration = result.migrations[m];
        CHECK(migration.generation == 4 * (m / 4 + 1));
        CHECK(migration.to == m % 4);
        CHECK(migration.from == (migration.to ^ (m / 4 % 2 == 0 ? 1u : 2u)));
        CHECK(migration.place.has_value());
    }
}

TEST_CASE(
    "a broadcast sends the same two emigrants to both neighbours; immigrants come in the order of their islands") {
    IslandsSettings settings = small_islands(5);
    settings.topology = RingTopology{2};
    settings.emigration = BestEmigration{2};
    auto migrations = run_on_line_record(settings).migrations;
    REQUIRE(migrations.size() == 13 * 5 * 4);
    std::vector<std::pair<std::size_t, std::size_t>> ways;
    for (std::size_t m = 0; m < 8; ++m)
        ways.emplace_back(migrations[m].from, migrations[m].to);
    CHECK(ways == std::vector<std::pair<std::size_t, std::size_t>>{
                      {1, 0}, {1, 0}, {4, 0}, {4, 0}, {0, 1}, {0, 1}, {2, 1}, {2, 1}});
    auto sent_by_1 = [&](std::size_t m) { return migrations[m].individual; };
    CHECK(sent_by_1(0) == sent_by_1(8)); // island 1 sends the same to island 0 and to island 2
    CHECK(sent_by_1(1) == sent_by_1(9));
    CHECK(sent_by_1(0).fitness >= sent_by_1(1).fitness);
}

TEST_CASE("an immigrant to an island with another window is evaluated in that window") {
    IslandsSettings settings = small_islands(2);
    settings.islands[1].window.length = 3;
    settings.islands[1].window.bias = 100;
    auto problem = make_search_problem(LineProblem{});
    auto record = line_record(line_samples);
    IslandsResult result = run_on_line_record(settings);
    REQUIRE(result.migrations.size() > 10);
    for (const Migration& migration : result.migrations) {
        std::size_t end = 5 + (migration.generation - 1) / 5,
                    length = migration.to == 0 ? std::min<std::size_t>(end, 10) : 3;
        CHECK(migration.individual.fitness == problem->fitness(migration.individual.genome,
                                                               std::span(record).subspan(end - length, length),
                                                               migration.to == 0 ? 400 : 100));
    }
    // Island 1's window is full after three samples. The island waits until the other island has five samples.
    CHECK(result.islands[1].estimates.front().sample == 4);
    CHECK(result.islands[1].generations == result.islands[0].generations);
}

TEST_CASE("the same seed gives the same run, and another seed or policy another run") {
    std::vector<IslandsResult> runs;
    test::EveryNth sampled(11);
    for (const char* topology : {"ring(2)", "hypercube", "star"})
        for (const char* schedule : {"broadcast(2)", "sequential(2)", "asynchronous(2)"})
            for (const char* emigration : {"best", "random(2)", "tournament"})
                for (const char* acceptance : {"worst", "random", "alike", "offspring"}) {
                    if (sampled.passes_over())
                        continue;
                    IslandsSettings settings = small_islands(4);
                    settings.topology = Topology::named(topology);
                    settings.schedule = Schedule::named(schedule);
                    settings.emigration = Emigration::named(emigration);
                    settings.acceptance = Acceptance::named(acceptance);
                    runs.push_back(run_on_line_record(settings));
                    CHECK(same(runs.back(), run_on_line_record(settings)));
                    CHECK_FALSE(same(runs.back(), run_on_line_record(settings, 2)));
                }
    for (std::size_t i = 0; i < runs.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            CHECK_FALSE(same(runs[i], runs[j]));
}

TEST_CASE("immigrants do not replace the elite: while the window stays the same, the best fitness never falls") {
    auto problem = make_search_problem(GreatestNumber{});
    for (const char* acceptance : {"worst", "random", "alike", "offspring"})
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            IslandsSettings settings = small_islands(4);
            settings.topology = CompleteTopology{};
            settings.schedule = BroadcastSchedule{1};
            settings.emigration = RandomEmigration{3};
            settings.acceptance = Acceptance::named(acceptance);
            for (SearchSettings& island : settings.islands)
                island.window.length = 1;
            Islands islands(*problem, settings, island_streams(seed, 4));
            islands.push({0});
            std::vector<double> best(4, -1e300);
            for (int generation = 0; generation < 30; ++generation) {
                islands.next_generation();
                for (std::size_t i = 0; i < 4; ++i) {
                    CHECK(islands.searches()[i].best().fitness >= best[i]);
                    best[i] = islands.searches()[i].best().fitness;
                }
            }
        }
}

TEST_CASE("with only_if_better, some immigrants are rejected, and their migrations have no place") {
    IslandsSettings settings = small_islands(4);
    settings.acceptance = RandomAcceptance{true};
    auto migrations = run_on_line_record(settings).migrations;
    auto away = std::ranges::count_if(migrations, [](const Migration& each) { return !each.place; });
    CHECK(away > 0);
    CHECK(away < static_cast<std::ptrdiff_t>(migrations.size()));
}

TEST_CASE("an immigrant among the offspring is evaluated one generation later, in the window of its new island") {
    IslandsSettings settings = barren(2, "ring", "broadcast(4)");
    settings.acceptance = OffspringAcceptance{};
    settings.islands[1].population = 15;
    Takeover takeover(settings);
    std::size_t other = 1 - takeover.home();
    for (int generation = 1; generation <= 4; ++generation) {
        takeover.next_generation();
        CHECK_FALSE(takeover.reached(other));
    }
    REQUIRE(takeover.migrations().size() == 2);
    const Migration& came = takeover.migrations().at(other);
    CHECK(came.generation == 4);
    CHECK(came.individual.genome == takeover.greatest());
    CHECK(came.place.value() >= 1); // outside the elite, which comes first
    CHECK(takeover.population(other).at(came.place.value()) == takeover.greatest());
    takeover.next_generation();
    CHECK(takeover.reached(other));
}

TEST_CASE("without a machine, asynchronous islands take turns, and an island with a short window does not wait") {
    Takeover takeover(barren(4, "ring", "asynchronous(1)"));
    for (std::size_t generation = 1; generation <= 5; ++generation) {
        takeover.next_generation();
        for (std::size_t i = 0; i < 4; ++i) {
            std::size_t away = (i + 4 - takeover.home()) % 4;
            bool had_its_turn = i < takeover.home(); // the last island sends to the first after the first island's turn
            CHECK(takeover.reached(i) == (away + had_its_turn <= generation));
        }
    }
    IslandsSettings settings = small_islands(3);
    settings.schedule = AsynchronousSchedule{2};
    settings.islands[1].window.length = 3;
    IslandsResult result = run_on_line_record(settings);
    CHECK(result.islands[0].generations == 40);
    CHECK(result.islands[1].generations == 50); // 5 for each of 10 samples, from the third on
    // At island 0's first exchange, no emigrants have been sent to it yet. Emigrants that island 1 sends before the
    // others begin are replaced by later ones.
    CHECK(result.migrations.size() == 19 + 20 + 20);
    CHECK(same(result, run_on_line_record(settings)));
}

TEST_CASE("islands that exchange begin together, and other islands do not wait for them") {
    IslandsSettings settings = small_islands(4);
    settings.topology = GivenTopology{{{1}, {0}, {3}, {2}}};
    CHECK(settings.warning() == "the islands form 2 groups that exchange nothing with each other: 0, 1; 2, 3");
    settings.topology = GivenTopology{{{1}, {2}, {3}, {0}}};
    CHECK(settings.warning().empty());
    settings.topology = GivenTopology{{{1}, {2}, {3}, {1}}};
    CHECK(settings.warning() == "no individual from island 1 ever reaches island 0");
    settings.topology = GivenTopology{{{1}, {0}, {3}, {2}}};
    settings.islands[1].window.length = settings.islands[2].window.length = settings.islands[3].window.length = 3;
    IslandsResult result = run_on_line_record(settings);
    CHECK(result.islands[0].estimates.front().sample == 4);
    CHECK(result.islands[1].estimates.front().sample == 4);
    CHECK(result.islands[2].estimates.front().sample == 2);
    CHECK(result.islands[2].generations == 50);
    settings.topology = NoTopology{};
    CHECK(settings.warning().empty());
    CHECK(run_on_line_record(settings).islands[1].generations == 50);
    CHECK(small_islands(4).warning().empty());
}

TEST_CASE("impossible settings of islands are refused, and the message states what would be right") {
    IslandsSettings settings = small_islands(3);
    settings.islands[2].window.trials = 4;
    CHECK(refusal(settings) == "island 0 makes 5 generations per sample, but island 2 makes 4; expected equal numbers, "
                               "because islands exchange in the same generations");
    settings = small_islands(3);
    settings.islands[1].population = 5;
    settings.emigration = BestEmigration{6};
    CHECK(refusal(settings) == "6 emigrants cannot leave a population of 5, expected at most 5");
    settings = small_islands(16);
    settings.topology = StarTopology{};
    CHECK(refusal(settings) ==
          "island 0: 15 immigrants come in one exchange to an island of 12 individuals with an elite of 1; "
          "expected at most 11");
    settings.schedule = SequentialSchedule{};
    // In a star, all other islands can send to island 0 at once.
    CHECK(refusal(settings).starts_with("island 0: 15 immigrants come in one exchange"));
    settings.topology = CompleteTopology{};
    CHECK(refusal(settings).empty()); // immigrants come from one island at a time
    settings.emigration = BestEmigration{12};
    CHECK(refusal(settings) ==
          "island 0: 12 immigrants come in one exchange to an island of 12 individuals with an elite of 1; "
          "expected at most 11");
    for (std::size_t population : {0u, 1u}) {
        settings = small_islands(3);
        settings.islands[2].population = population;
        settings.islands[2].elite = 0;
        CHECK(refusal(settings) ==
              fmt::format("the population is {}, expected at least 2: crossover needs two parents", population));
    }
    settings = small_islands(12);
    settings.topology = HypercubeTopology{};
    CHECK(refusal(settings) == "a hypercube cannot have 12 islands, expected a power of two such as 8 or 16");
    CHECK(refusal(small_islands(0)) == "the number of islands is 0, expected at least 1");
    CHECK(refusal(small_islands(1)).starts_with("island 0 of 1 has no neighbours"));
    settings = small_islands(2);
    settings.islands[1].window.length = 13;
    CHECK(refusal(settings) == "the window holds 13 samples, but the record has only 12");
    CHECK_THROWS_WITH_AS(Islands(*make_search_problem(LineProblem{}), small_islands(2), island_streams(1, 3)),
                         "3 streams of random numbers for 2 islands, expected one stream for each island",
                         std::invalid_argument);
}
