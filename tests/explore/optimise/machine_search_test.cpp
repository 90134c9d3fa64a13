#include "explore/optimise/optimise_report.hpp"
#include "tests/explore/optimise/landscape.hpp"
#include "tests/scratch.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

using Costs = std::set<std::vector<double>>;

/// Returns the costs of the machines that no other machine dominates.
Costs best_costs(const SearchCourse& course) {
    Costs costs;
    for (std::size_t place : course.front())
        costs.insert(course.merits[place].costs);
    return costs;
}

double least_cost(const SearchCourse& course) { return best_costs(course).begin()->front(); }

std::string folder_of(const Scratch& scratch) { return (scratch / ".").string(); }

StudySearch wanting(std::vector<std::string> minimise, std::uint64_t population, std::uint64_t generations,
                    std::uint64_t seed = 1) {
    return {.minimise = std::move(minimise), .population = population, .generations = generations, .seed = seed};
}

/// Returns whether both searches tried the same machines in the same order, with the same costs.
bool same_course(const SearchCourse& a, const SearchCourse& b) {
    return a.machines == b.machines &&
           std::ranges::equal(a.merits, b.merits, [](const Merit& x, const Merit& y) { return x.costs == y.costs; });
}

} // namespace

TEST_CASE("every machine has a genome, and every genome codes a machine") {
    Scratch scratch;
    Landscape landscape{.vals = 2, .values = 5};
    LandscapeSearch tried(folder_of(scratch), landscape, wanting({"time"}, 8, 1));
    const MachineSpace& space = tried.space();
    CHECK(space.count() == 25);
    CHECK(space.bits() == 6);
    std::set<std::uint64_t> machines;
    for (std::uint64_t code = 0; code < 64; ++code) {
        Genome genome(6);
        genome.set_field(0, 6, code);
        machines.insert(space.machine_of(genome));
    }
    CHECK(machines.size() == 25);
    CHECK(*machines.rbegin() == 24);
    CHECK(space.settings(7) == Overrides{{"v0", "1"}, {"v1", "2"}});
}

TEST_CASE("in small spaces the search finds the optimum of the exhaustive search") {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        Scratch scratch;
        LandscapeSearch tried(folder_of(scratch), {.vals = 3, .values = 4, .seed = seed}, wanting({"time"}, 16, 25));
        auto genetic = tried.search().genetic(), exhaustive = tried.search().exhaustive();
        CHECK(exhaustive->machines.size() == 64);
        CHECK(genetic->machines.size() < 64);
        CHECK(least_cost(*genetic) == least_cost(*exhaustive));
    }
}

TEST_CASE("the search finds better machines than a random search with the same number of machines") {
    int better = 0, worse = 0;
    for (std::uint64_t seed = 101; seed <= 120; ++seed) {
        Scratch scratch;
        LandscapeSearch tried(folder_of(scratch), {.vals = 8, .values = 8, .seed = seed},
                              wanting({"time"}, 24, 30, seed));
        auto genetic = tried.search().genetic();
        auto random = tried.search().random(genetic->machines.size());
        REQUIRE(random->machines.size() == genetic->machines.size());
        better += least_cost(*genetic) < least_cost(*random) ? 1 : 0;
        worse += least_cost(*genetic) > least_cost(*random) ? 1 : 0;
    }
    CAPTURE(better);
    CHECK(better >= 15); // if neither search were better, 15 or more of 20 would have a chance of 2 %
    CHECK(worse <= 5);
}

TEST_CASE("two measures give the front that the exhaustive search finds") {
    int wide = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        Scratch scratch;
        LandscapeSearch tried(folder_of(scratch), {.vals = 3, .values = 4, .seed = seed, .four_links = true},
                              wanting({"time", "links"}, 24, 25));
        auto genetic = tried.search().genetic(), exhaustive = tried.search().exhaustive();
        Costs front = best_costs(*exhaustive);
        wide += front.size() > 1 ? 1 : 0;
        CHECK(best_costs(*genetic) == front);
    }
    CHECK(wide >= 3);
}

TEST_CASE("machines that the netlist or the condition refuses are not simulated") {
    Scratch scratch;
    LandscapeSearch tried(folder_of(scratch), {.vals = 3, .values = 4, .four_links = true}, wanting({"time"}, 16, 10),
                          "v1 != v2");
    auto genetic = tried.search().genetic(), random = tried.search().random(1000), all = tried.search().exhaustive();
    std::set<std::uint64_t> can_be;
    for (std::uint64_t machine = 0; machine < 64; ++machine)
        if (machine / 16 + machine / 4 % 4 <= 4 && machine / 4 % 4 != machine % 4)
            can_be.insert(machine);
    CHECK(std::set(all->machines.begin(), all->machines.end()) == can_be);
    CHECK(std::set(random->machines.begin(), random->machines.end()) == can_be);
    CHECK(random->machines.size() == can_be.size());
    for (std::uint64_t machine : genetic->machines)
        CHECK(can_be.contains(machine));
    CHECK(genetic->tried.size() > genetic->machines.size());
    CHECK(genetic->why.contains("the study's condition \"where\" is not met"));
    tried.results().for_each([&](const StudyRun& run, const StudyOutcome& outcome) {
        int wanted = std::stoi(run.set.at("v0")) + std::stoi(run.set.at("v1"));
        CHECK((outcome.ended == "refused") == (wanted > 4));
        CHECK(run.set.at("v1") != run.set.at("v2"));
    });
}

TEST_CASE("the search's course does not depend on the number of workers or on interruptions") {
    const Landscape landscape{.vals = 5, .values = 5, .four_links = true};
    const StudySearch wanted = wanting({"time", "links"}, 20, 6, 7);
    Scratch whole, many, broken;
    auto expected = LandscapeSearch(folder_of(whole), landscape, wanted).search().genetic();
    auto parallel = LandscapeSearch(folder_of(many), landscape, wanted, "", 3).search().genetic();
    CHECK(same_course(*expected, *parallel));
    {
        LandscapeSearch first(folder_of(broken), landscape, wanting({"time", "links"}, 20, 3, 7));
        first.search().genetic();
        first.interruption().request();
        CHECK_FALSE(first.search().random(50).has_value());
    }
    LandscapeSearch second(folder_of(broken), landscape, wanted);
    std::uint64_t kept = second.results().count();
    CHECK(kept > 0);
    auto resumed = second.search().genetic();
    CHECK(same_course(*expected, *resumed));
    CHECK(second.results().count() > kept);
    CHECK(second.results().count() == LandscapeSearch(folder_of(whole), landscape, wanted).results().count());
}

TEST_CASE("another seed gives another course") {
    const Landscape landscape{.vals = 5, .values = 5};
    Scratch scratch;
    auto one = LandscapeSearch(folder_of(scratch), landscape, wanting({"time"}, 10, 2, 1)).search().genetic();
    auto other = LandscapeSearch(folder_of(scratch), landscape, wanting({"time"}, 10, 2, 2)).search().genetic();
    CHECK(one->machines != other->machines);
}

TEST_CASE("studies that cannot be searched are refused") {
    Scratch scratch;
    const Landscape landscape{.vals = 2, .values = 4};
    LandscapeSearch no_such(folder_of(scratch), landscape, wanting({"tim"}, 8, 3));
    CHECK_THROWS_WITH_AS(no_such.search().genetic(), doctest::Contains("did you mean \"time\"?"), UserError);
    Scratch other;
    LandscapeSearch nothing(folder_of(other), landscape, wanting({"time"}, 8, 3), "v0 > 2 || v0 <= 2");
    CHECK(nothing.search().genetic().has_value());
    Study fixed;
    fixed.products.push_back({.axes = {read_axis("a=1")}});
    CHECK_THROWS_AS(MachineSpace{fixed}, UserError);
    fixed.products.push_back({.axes = {read_axis("a=1,2")}});
    CHECK_THROWS_AS(MachineSpace{fixed}, UserError);
}

TEST_CASE("the results of several methods count together: the best machine may come from any of them") {
    auto costing = [](double cost) { return Merit{true, {cost}}; };
    Optimum optimum;
    optimum.courses = {{.way = "genetic", .machines = {1, 2}, .merits = {costing(5), costing(4)}},
                       {.way = "random", .machines = {2, 3}, .merits = {costing(4), costing(3)}}};
    SearchCourse all = optimum.together();
    CHECK(all.machines == std::vector<std::uint64_t>{1, 2, 3});
    CHECK(all.machines[best_of(all).front()] == 3);
    CHECK(least_cost(all) == 3);
}
