// Tests logs against values computed by hand, and logs of the simulated machine against logs of the library.

#include "gaprocs/generation_log.hpp"

#include "gaprocs/checkpoints.hpp"
#include "gaprocs/islands.hpp"
#include "gaprocs/traditional.hpp"
#include "gaprocs/usual_settings.hpp"
#include "tests/gaprocs/island_netlist.hpp"
#include "tests/gaprocs/strings.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <limits>
#include <stdexcept>

using namespace placedpar;

namespace {

/// Returns rows as text, such as "2 east best 7"; for an immigrant "2 east turned_away 3 from west".
std::vector<std::string> texts_of(const GenerationLog& log) {
    std::vector<std::string> texts;
    for (const LogRow& row : log.rows())
        texts.push_back(fmt::format("{} {} {} {}{}{}", row.generation, row.search, row.quantity, row.value,
                                    row.from.empty() ? "" : " from ", row.from));
    return texts;
}

void tell(SearchObserver& log, const char* search, std::uint64_t number, const std::vector<Genome>& population,
          const std::vector<double>& fitness) {
    log.observe({search, number, std::nullopt, BitString(population.front().size()), population, fitness});
}

/// Returns the library's settings for the islands of a Cluster.
IslandsSettings islands_of(const Cluster& cluster) {
    SearchSettings each;
    each.population = static_cast<std::size_t>(cluster.population);
    IslandsSettings settings;
    settings.islands.assign(static_cast<std::size_t>(cluster.islands), each);
    return settings;
}

std::vector<RandomStream> streams_of(const std::vector<std::string>& names) {
    std::vector<RandomStream> streams;
    for (const std::string& name : names)
        streams.emplace_back(1, name);
    return streams;
}

std::vector<std::string> masters(int islands) {
    std::vector<std::string> names;
    for (int i = 0; i < islands; ++i)
        names.push_back(fmt::format("master{}", i));
    return names;
}

/// Returns the rows as text, in which each search has the name `name` followed by its number. REQUIRES: at most 10
/// searches.
std::vector<std::string> texts_named(const GenerationLog& log, std::string_view name) {
    auto texts = texts_of(log);
    for (std::string& text : texts)
        for (std::size_t i = 0; i < log.searches().size(); ++i)
            boost::algorithm::replace_all(text, log.searches()[i], fmt::format("{}{}", name, i));
    return texts;
}

void check_logs(const GenerationLog& machine, const GenerationLog& library) {
    CHECK(texts_of(machine).size() > 40 * 4 * machine.searches().size() / 2);
    CHECK(texts_named(machine, "island") == texts_named(library, "island"));
    CHECK(std::ranges::all_of(machine.rows(), [](const LogRow& row) { return row.time.has_value(); }));
    CHECK(std::ranges::none_of(library.rows(), [](const LogRow& row) { return row.time.has_value(); }));
}

void check_ring_of_masters(const Cluster& cluster) {
    auto names = masters(cluster.islands);
    GenerationLog machine(names), library(island_names(names.size()));
    run_on_line(cluster.netlist(), 1, &machine);
    auto problem = make_search_problem(LineProblem{});
    run_islands(*problem, line_record(line_samples), islands_of(cluster), streams_of(names), &library);
    check_logs(machine, library);
}

/// Returns five islands with different populations and windows.
IslandsSettings five_islands() {
    IslandsSettings settings = islands_of({.islands = 5, .population = 9});
    settings.islands[1].population = 12;
    settings.islands[3].window.length = 7;
    for (SearchSettings& each : settings.islands)
        each.elite = 1;
    return settings;
}

void check_islands(const IslandsSettings& settings) {
    auto names = island_names(settings.islands.size());
    GenerationLog machine(names), library(names);
    run_on_line(test::IslandNetlist{settings}.text(), 1, &machine);
    auto problem = make_search_problem(LineProblem{});
    run_islands(*problem, line_record(line_samples), settings, island_streams(1, names.size()), &library);
    check_logs(machine, library);
}

/// Returns the log of one search of the problem.
GenerationLog searched(const SearchProblem& problem, std::size_t generations) {
    GenerationLog log({"traditional"});
    SearchSettings settings = usual_settings(problem);
    settings.population = 20;
    run_traditional(problem, generations, settings, RandomStream(1, "alone"), &log);
    return log;
}

constexpr double beyond_all = std::numeric_limits<double>::infinity();

} // namespace

TEST_CASE("the log of two islands of two strings has the rows computed by hand") {
    GenerationLog log({"east", "west"});
    tell(log, "west", 1, test::strings({"0000", "0001"}), {2, 4});
    CHECK(log.of_all().empty());
    tell(log, "east", 1, test::strings({"1111", "1110"}), {5, 1});
    log.observe({"east", "west", 2, std::nullopt, 5, true});
    log.observe({"west", "east", 2, std::nullopt, -1, false});
    tell(log, "west", 2, test::strings({"1111", "0001"}), {3, 2});
    tell(log, "east", 2, test::strings({"1111", "1111"}), {3, 3});
    CHECK(texts_of(log) == std::vector<std::string>{"1 east best_so_far 5",
                                                    "1 east best 5",
                                                    "1 east mean 3",
                                                    "1 east diversity 0.25",
                                                    "1 west best_so_far 4",
                                                    "1 west best 4",
                                                    "1 west mean 3",
                                                    "1 west diversity 0.25",
                                                    "1 all best_so_far 5",
                                                    "1 all best 5",
                                                    "1 all mean 3",
                                                    "1 all diversity 0.25",
                                                    "1 all diversity_between 0.875",
                                                    fmt::format("1 all fixation {}", 1 - 0.25 / 0.875),
                                                    "2 east turned_away -1 from west",
                                                    "2 east best_so_far 5",
                                                    "2 east best 3",
                                                    "2 east mean 3",
                                                    "2 east diversity 0",
                                                    "2 west accepted 5 from east",
                                                    "2 west best_so_far 4",
                                                    "2 west best 3",
                                                    "2 west mean 2.5",
                                                    "2 west diversity 0.75",
                                                    "2 all best_so_far 5",
                                                    "2 all best 3",
                                                    "2 all mean 2.75",
                                                    "2 all diversity 0.375",
                                                    "2 all diversity_between 0.375",
                                                    "2 all fixation 0"});
}

TEST_CASE("a log of one search, or of searches of different problems, has no rows for all searches together") {
    GenerationLog one({"alone"}), different({"east", "west"}, false);
    tell(one, "alone", 1, test::strings({"00", "01"}), {2, 4});
    tell(different, "east", 1, test::strings({"00", "01"}), {2, 4});
    tell(different, "west", 1, test::strings({"000", "011"}), {2, 4});
    CHECK(one.rows().size() == 4);
    CHECK(different.rows().size() == 8);
    CHECK_FALSE(one.compares());
    CHECK(one.of(0).front().best == 4);
    CHECK_THROWS_AS(tell(one, "another", 1, test::strings({"00"}), {1}), std::invalid_argument);
}

TEST_CASE("the best value so far begins with that of a checkpoint") {
    struct OneCheckpoint final : Checkpoints {
        SearchCheckpoint begin{
            .search = {}, .best = {test::strings({"01"}).front(), -2}, .improvements = {{1, -4}, {3, -2}}};
        const SearchCheckpoint* begin_of(const std::string& search) const override {
            return search == "east" ? &begin : nullptr;
        }
        bool is_due(std::uint64_t) const override { return false; }
        void keep(const std::string&, const SearchCheckpoint&) override {}
    } checkpoints;
    GenerationLog log({"east", "west"});
    log.continue_from(checkpoints);
    const auto population = test::strings({"00", "01"});
    for (const char* search : {"east", "west"})
        log.observe({search, 8, std::nullopt, BitString(2), population, std::vector<double>{-5, -3}, Goal::minimise});
    CHECK(log.of(0)[0].best_so_far == 2);
    CHECK(log.of(1)[0].best_so_far == 3);
    CHECK(log.of_all()[0].best_so_far == 2);
    CHECK(log.of_all()[0].best == 3);
    CHECK(log.steps_of(0) == std::vector<LoggedStep>{{1, 4}, {3, 2}});
    CHECK(log.steps_of(1) == std::vector<LoggedStep>{{8, 3}});
    CHECK(log.steps_of_all() == std::vector<LoggedStep>{{1, 4}, {3, 2}});
}

TEST_CASE("a minimised objective is logged without negation, and the least value is the best") {
    GenerationLog log({"east", "west"});
    auto say = [&](const char* search, std::uint64_t number, const std::vector<double>& fitness) {
        auto population = test::strings({"00", "01"});
        log.observe({search, number, std::nullopt, BitString(2), population, fitness, Goal::minimise});
    };
    say("east", 1, {-5, -3});
    say("west", 1, {-7, -1});
    say("east", 2, {-4, -8});
    say("west", 2, {-2, 0});
    log.observe({"east", "west", 2, std::nullopt, -6, true});
    CHECK(log.minimises(1));
    CHECK(log.of(0)[0].best == 3);
    CHECK(log.of(0)[1].best == 4);
    CHECK(log.of(0)[1].best_so_far == 3);
    CHECK(log.of(0)[1].mean == 6);
    CHECK(log.of_all()[0].best == 1);
    CHECK(log.of_all()[1].mean == 3.5);
    auto texts = texts_of(log);
    CHECK(std::ranges::count(texts, "2 west accepted 6 from east") == 1);
    CHECK(std::ranges::count(texts, "2 west best 0") == 1);
}

TEST_CASE("the log of islands on the machine equals the library's log apart from the times") {
    check_ring_of_masters({.islands = 2, .population = 10});
    check_ring_of_masters({.islands = 4, .population = 30});
    check_ring_of_masters({.slaves = 2, .islands = 3, .population = 9, .split = "evaluations"});
}

TEST_CASE(
    "with any topology and policies, the log of islands on the machine equals the library's log apart from the times") {
    test::EveryNth sampled(21);
    for (const char* topology : {"ring(2)", "star", "complete", "none"})
        for (const char* schedule : {"broadcast(2)", "sequential(1)"})
            for (const char* emigration : {"best", "random(2)"})
                for (const char* acceptance : {"worst", "random(1)", "alike(1)", "offspring"}) {
                    if (sampled.passes_over())
                        continue;
                    CAPTURE(topology);
                    CAPTURE(schedule);
                    CAPTURE(emigration);
                    CAPTURE(acceptance);
                    IslandsSettings settings = five_islands();
                    settings.topology = Topology::named(topology);
                    settings.schedule = Schedule::named(schedule);
                    settings.emigration = Emigration::named(emigration);
                    settings.acceptance = Acceptance::named(acceptance);
                    check_islands(settings);
                }
}

TEST_CASE("in a log of asynchronous islands, an immigrant is in a generation of the island to which it comes") {
    IslandsSettings settings = five_islands();
    settings.schedule = AsynchronousSchedule{2};
    settings.islands[1].window.length = 3; // this island starts before the others
    GenerationLog machine(island_names(5)), library(island_names(5));
    auto problem = make_search_problem(LineProblem{});
    auto run = run_islands(*problem, line_record(line_samples), settings, island_streams(1, 5), &library);
    test::IslandNetlist netlist{settings, test::IslandNetlist::On::four_transputers};
    netlist.other_transputer = "clock = 30M";
    run_on_line(netlist.text(), 1, &machine);
    CHECK(machine.of(1).size() == 50);
    CHECK(machine.of_all().size() == 40);
    for (const GenerationLog* log : {&machine, &library})
        for (const LoggedMigration& each : log->migrations())
            CHECK(each.generation % 2 == 0);
    REQUIRE(library.migrations().size() == run.migrations.size());
    auto out_of_step = [&](std::size_t i) {
        return library.migrations()[i].generation != run.migrations[i].generation;
    };
    std::size_t from_another = 0;
    for (std::size_t i = 0; i < run.migrations.size(); ++i)
        from_another += out_of_step(i);
    CHECK(from_another > 10); // island 1 is 10 generations ahead of the islands to which it sends
}

TEST_CASE("every kind of search process is observed") {
    std::string netlist =
        "workstation sun; T800 t[2]; process host; process master; process slave; process alone;\n"
        "process island[2]; use \"ga.host\" for host; use \"ga.master\" for master;\n"
        "use \"ga.slave\" for slave; use \"ga.traditional\" for alone;\n"
        "rep i = 0 for 2 { use \"ga.island\" for island[i]; place island[i] on sun;\n"
        "    connect host.to_masters[i] to island[i].from_host;\n"
        "    connect island[i].to_neighbours[0] to island[1 - i].from_neighbours[0];\n"
        "    island[i] (problem = \"line\", population = 10); connect sun.link[i] to t[i].link[0]; }\n"
        "connect t[0].link[1] to t[1].link[1];\n"
        "connect host.to_masters[2] to master.from_host; connect host.to_masters[3] to "
        "alone.from_host;\n"
        "connect master.to_slaves to slave.from_master; connect slave.to_master to "
        "master.from_slaves;\n"
        "place host on sun; place alone on sun; place master on t[0]; place slave on t[1];\n"
        "host (problem = \"line\"); slave (problem = \"line\");\n"
        "master (problem = \"line\", population = 10, slaves = 1); alone (problem = \"line\", "
        "population = 10);\n";
    GenerationLog log({"master", "alone", "island[0]", "island[1]"});
    run_on_line(netlist, 1, &log);
    for (std::size_t i = 0; i < 4; ++i)
        CHECK(log.of(i).size() == 40);
    CHECK(log.of_all().size() == 40);
}

TEST_CASE("a log of an objective problem has the best objective of each generation") {
    GenerationLog sphere = searched(*minimise(PlainSphere{}), 50);
    REQUIRE(sphere.of(0).size() == 50);
    CHECK(sphere.minimises(0));
    CHECK(sphere.of(0).back().best_so_far >= 0);
    CHECK(sphere.of(0).back().best_so_far < 0.2);
    CHECK(sphere.of(0).back().mean >= sphere.of(0).back().best);
    GenerationLog machine({"master0"});
    Cluster cluster{.population = 12, .problem = "sphere", .host_parameters = "generations = 30"};
    RunReport report = run_on_line(cluster.netlist(), 1, &machine);
    CHECK(machine.of(0).size() == 30);
    CHECK(machine.of(0).back().best_so_far == report.measured("master0", "best_objective"));
}

TEST_CASE("an objective that is not a finite number is logged as infinite, and the mean omits it") {
    GenerationLog log({"east", "west"});
    auto say = [&](const char* search, const std::vector<double>& fitness) {
        auto population = test::strings({"00", "01", "11"});
        log.observe({search, 1, std::nullopt, BitString(2), population, fitness, Goal::minimise});
    };
    say("east", {-3, worst_fitness, -5});
    say("west", {worst_fitness, worst_fitness, worst_fitness});
    CHECK(log.of(0)[0].best == 3);
    CHECK(log.of(0)[0].mean == 4);
    CHECK(log.of(1)[0].best == beyond_all);
    CHECK(log.of(1)[0].mean == beyond_all);
    CHECK(log.of_all()[0].best == 3);
    CHECK(log.of_all()[0].mean == 4);
    GenerationLog sought({"east"}), nowhere = searched(*minimise(Nowhere{}), 5);
    auto population = test::strings({"00", "01"});
    std::vector<double> fitness{worst_fitness, worst_fitness};
    sought.observe({"east", 1, std::nullopt, BitString(2), population, fitness, Goal::maximise});
    CHECK(sought.of(0)[0].best == -beyond_all);
    CHECK(nowhere.of(0).back().best_so_far == beyond_all);
}

TEST_CASE("the diversity in a log is that of the representation") {
    auto problem = minimise(Seats{});
    SearchSettings settings = usual_settings(*problem);
    settings.population = 10;
    settings.crossover_probability = settings.mutation_probability = 0;
    RandomStream random(1, "island[0]");
    auto first = problem->representation().random_population(10, random);
    GenerationLog log({"traditional"});
    run_traditional(*problem, 3, settings, RandomStream(1, "island[0]"), &log);
    CHECK(log.of(0).front().diversity == diversity_within(spread_of(first, problem->representation())));
    CHECK(log.of(0).front().diversity > 0.5);
}

TEST_CASE("the log of a master with slaves equals that of the traditional algorithm apart from the times") {
    Cluster cluster{.slaves = 2, .population = 20};
    GenerationLog machine({"master0"}), library({"traditional"});
    run_on_line(cluster.netlist(), 1, &machine);
    auto problem = make_search_problem(LineProblem{});
    run_traditional(*problem, line_record(line_samples), islands_of(cluster).islands.front(),
                    RandomStream(1, cluster.stream), &library);
    CHECK(texts_of(machine).size() == 4 * 40);
    check_logs(machine, library);
    CHECK(std::ranges::is_sorted(machine.of(0), {}, [](const LoggedGeneration& each) { return each.time; }));
}

TEST_CASE("a log has exactly the migrations of the islands") {
    auto problem = make_search_problem(LineProblem{});
    IslandsSettings settings = islands_of({.islands = 4, .population = 6});
    settings.topology = Topology::named("complete");
    settings.acceptance = Acceptance::named("worst(only_if_better = 1)");
    GenerationLog log(island_names(4));
    auto run = run_islands(*problem, line_record(line_samples), settings, island_streams(1, 4), &log);
    REQUIRE(log.migrations().size() == run.migrations.size());
    std::size_t turned_away = 0;
    for (std::size_t i = 0; i < run.migrations.size(); ++i) {
        const Migration& ran = run.migrations[i];
        const LoggedMigration& logged = log.migrations()[i];
        CHECK(logged.from == ran.from);
        CHECK(logged.to == ran.to);
        CHECK(logged.generation == ran.generation);
        CHECK(logged.fitness == ran.individual.fitness);
        CHECK(logged.accepted == ran.place.has_value());
        turned_away += logged.accepted ? 0 : 1;
    }
    CHECK(turned_away > 0);
    CHECK(turned_away < run.migrations.size());
}

TEST_CASE("an observer does not change the run") {
    Cluster cluster{.slaves = 1, .islands = 3, .population = 12};
    GenerationLog log(masters(3));
    RunReport observed = run_on_line(cluster.netlist(), 1, &log), alone = run_on_line(cluster.netlist());
    CHECK(observed.result.fingerprint == alone.result.fingerprint);
    CHECK(log.of_all().back().best_so_far >= log.of_all().back().best);
    CHECK(log.of(1).back().best == observed.measured("master1", "best_fitness"));
}
