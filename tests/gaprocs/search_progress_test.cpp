// Tests that searches of the library go on from checkpoints with the generations of an unbroken run.

#include "gaprocs/checkpoints.hpp"
#include "gaprocs/front_search.hpp"
#include "gaprocs/islands.hpp"
#include "gaprocs/usual_settings.hpp"
#include "tests/gaprocs/line_problem.hpp"
#include "tests/gaprocs/objectives.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <map>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Keeps the states in memory.
class MemoryOfStates final : public Checkpoints {
public:
    explicit MemoryOfStates(std::uint64_t every) : every_(every) {}
    const SearchCheckpoint* begin_of(const std::string& search) const override {
        const auto found = begin.find(search);
        return found == begin.end() ? nullptr : &found->second;
    }
    bool is_due(std::uint64_t generation) const override { return generation % every_ == 0; }
    void keep(const std::string& search, const SearchCheckpoint& state) override { kept[search] = state; }

    std::map<std::string, SearchCheckpoint> begin, kept;

private:
    std::uint64_t every_;
};

IslandsSettings settings_of(const SearchProblem& problem, const char* schedule, const char* acceptance) {
    SearchSettings each = usual_settings(problem);
    each.population = 14;
    IslandsSettings settings;
    settings.islands.assign(3, each);
    settings.schedule = Schedule::named(schedule);
    settings.acceptance = Acceptance::named(acceptance);
    return settings;
}

void check_equal(const SearchResult& whole, const SearchResult& second) {
    CHECK(second.population == whole.population);
    CHECK(second.generations == whole.generations);
    CHECK(second.redraws == whole.redraws);
    CHECK(second.best().best == whole.best().best);
    CHECK(second.estimates.back().best == whole.estimates.back().best);
}

} // namespace

TEST_CASE("islands go on from a checkpoint with the generations of an unbroken run, bit for bit") {
    auto seats = minimise(Seats{}), plane = minimise(Plane{}), sphere = minimise(PlainSphere{});
    for (const auto& problem : {seats, plane, sphere})
        for (const char* schedule : {"broadcast", "sequential"})
            for (const char* acceptance : {"worst", "offspring"}) {
                const IslandsSettings settings = settings_of(*problem, schedule, acceptance);
                const IslandsResult whole = run_islands(*problem, 40, settings, island_streams(7, 3));
                MemoryOfStates states(5);
                run_islands(*problem, 23, settings, island_streams(7, 3), nullptr, &states);
                REQUIRE(states.kept.at("island[1]").search.generation == 20);
                states.begin = states.kept;
                const IslandsResult second =
                    run_islands(*problem, 40, settings, island_streams(7, 3), nullptr, &states);
                for (std::size_t i = 0; i < 3; ++i)
                    check_equal(whole.islands[i], second.islands[i]);
                CHECK(states.kept.at("island[2]").search.generation == 40);
            }
}

TEST_CASE("a search over a record goes on at the sample at which the earlier run ended") {
    auto problem = make_search_problem(LineProblem{});
    auto record = line_record(20);
    const SearchResult whole = run_traditional(*problem, record, {}, RandomStream(3, "line"));
    MemoryOfStates states(1);
    run_traditional(*problem, std::span(record).first(12), {}, RandomStream(3, "line"), nullptr, &states);
    states.begin = states.kept;
    const SearchResult second = run_traditional(*problem, record, {}, RandomStream(3, "line"), nullptr, &states);
    CHECK(second.population == whole.population);
    CHECK(second.estimates.front().sample == 12);
    CHECK(second.estimates.back().best == whole.estimates.back().best);
}

TEST_CASE("a search for a front goes on from a checkpoint, and tells which generations are done") {
    auto problem = minimise(PlainSphere{});
    const SearchSettings settings = front_settings(problem->representation(), 20);
    std::vector<std::uint64_t> told;
    const auto front = [&](std::size_t generations, MemoryOfStates* states) {
        told.clear();
        return search_front(
            *problem, generations, settings, RandomStream(3, "front"),
            [&](std::uint64_t generation) { told.push_back(generation); }, states);
    };
    MemoryOfStates states(5);
    front(13, &states);
    REQUIRE(states.kept.at("front").search.generation == 10);
    const FrontResult whole = front(15, nullptr);
    states.begin = states.kept;
    const FrontResult second = front(15, &states);
    CHECK(told == std::vector<std::uint64_t>{11, 12, 13, 14, 15});
    CHECK(second.evaluations == 20 + 4 * 10);
    REQUIRE(second.front.size() == whole.front.size());
    for (std::size_t i = 0; i < whole.front.size(); ++i)
        CHECK(second.front[i].genome == whole.front[i].genome);
}

TEST_CASE("a checkpoint of another search, or of a later generation, is refused") {
    auto problem = minimise(PlainSphere{});
    MemoryOfStates states(1);
    SearchSettings settings = usual_settings(*problem);
    run_traditional(*problem, 9, settings, RandomStream(3, "s"), nullptr, &states);
    states.begin = states.kept;
    CHECK_THROWS_WITH_AS(run_traditional(*problem, 5, settings, RandomStream(3, "s"), nullptr, &states),
                         "this search ends with generation 5, before the generation of the checkpoint: let the search "
                         "run longer, or delete the checkpoint to start from the beginning",
                         UserError);
    settings.population = 30;
    CHECK_THROWS_AS(run_traditional(*problem, 20, settings, RandomStream(3, "s"), nullptr, &states), UserError);
}
