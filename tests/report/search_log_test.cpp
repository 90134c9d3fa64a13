// Tests the file of a run's log, and the report's text about it.

#include "report/search_log.hpp"

#include "report/search_report.hpp"
#include "tests/report/small_log.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

using namespace placedpar;

TEST_CASE("a log is written as comma-separated values, one value a row") {
    SeededLog seeded{7, GenerationLog({"east", "west"})};
    test::tell(seeded.log, "east", 1, {0.1, 2}, Time{1'500'000'000});
    seeded.log.observe({"east", "west", 2, Time{2'000'000'000}, -3.25, false});
    CHECK(log_csv({&seeded, 1}) == "seed,generation,time_ms,process,from,quantity,value\n"
                                   "7,1,1.5,east,,best_so_far,2\n"
                                   "7,1,1.5,east,,best,2\n"
                                   "7,1,1.5,east,,mean,1.05\n"
                                   "7,1,1.5,east,,diversity,0.5\n"
                                   "7,2,2,west,east,turned_away,-3.25\n");
}

TEST_CASE("in a log without virtual time the column of times is empty") {
    SeededLog seeded{1, GenerationLog({"east"})};
    test::tell(seeded.log, "east", 1, {3, 3});
    CHECK(log_csv({&seeded, 1}).find("\n1,1,,east,,best,3\n") != std::string::npos);
}

TEST_CASE("the report has the beginning and end of searches, and the fate of immigrants") {
    GenerationLog log({"east", "west"});
    for (const char* search : {"east", "west"}) {
        test::tell(log, search, 1, {0, 100});
        test::tell(log, search, 2, {100, 199});
        test::tell(log, search, 3, {150, 200});
    }
    log.observe({"east", "west", 2, std::nullopt, 1, true});
    log.observe({"west", "east", 2, std::nullopt, 1, false});
    auto json = searches_json(log);
    REQUIRE(json.size() == 3);
    CHECK(json[0].at("process") == "east");
    CHECK(json[0].at("generations") == 3);
    CHECK(json[0].at("first").at("best") == 100.0);
    CHECK(json[0].at("last").at("mean") == 175.0);
    CHECK(json[0].at("generation_at_99_percent") == 2);
    CHECK(json[0].at("immigrants_turned_away") == 1);
    CHECK(json[1].at("immigrants_accepted") == 1);
    CHECK(json[2].at("process") == "all");
    CHECK(json[2].at("immigrants_accepted") == 1);
    CHECK(json[2].at("last").at("diversity_between") == 0.25);
    std::string text = print_searches(log);
    CHECK(text.find("\neast              3          100          200          200           50          175        2   "
                    "  0.5000") != std::string::npos);
    CHECK(text.find("diversity between searches: 0.2500 in the first generation, 0.2500 in the last") !=
          std::string::npos);
}

TEST_CASE("a report of several seeds gives medians and quartiles") {
    std::vector<SeededLog> logs;
    for (double best : {1, 5, 2, 4}) {
        logs.push_back({1, GenerationLog({"east"})});
        test::tell(logs.back().log, "east", 1, {10 * best, 0});
        test::tell(logs.back().log, "east", 2, {best, 0});
    }
    std::string text = print_searches(logs);
    CHECK(text.find("3 [1, 4]") != std::string::npos);
    CHECK(text.find("30 [10, 40]") != std::string::npos); // the best so far
    CHECK(text.find("1.5 [0.5, 2]") != std::string::npos);
}

TEST_CASE("the report leaves out searches without generations") {
    CHECK(print_searches(GenerationLog({})).empty());
    CHECK(print_searches(GenerationLog({"east"})).empty());
    CHECK(searches_json(GenerationLog({"east"})).empty());
    CHECK_THROWS_AS(require_searches(Network{}), UserError);
}

TEST_CASE("searches of the same problem in the same coding are compared") {
    auto search = [](const char* name, const char* problem) {
        ProcessInstance process;
        process.name = name;
        process.kind = "ga.island";
        process.parameters = {{"population", Value(std::int64_t{10})},
                              {"trials", Value(std::int64_t{1})},
                              {"problem", Value(std::string(problem))}};
        return process;
    };
    Network network;
    network.processes = {search("a", "boom"), ProcessInstance(), search("b", "boom")}; // one process does not search
    const GenerationLog log = log_of(network);
    CHECK(std::ranges::equal(log.searches(), std::vector<std::string>{"a", "b"}));
    CHECK(log.compares());
    network.processes[2].parameters["problem"] = Value(std::string("plant"));
    CHECK_FALSE(log_of(network).compares());
    network.processes[2] = search("b", "boom");
    network.processes[0].kind = "ga.coarse"; // its strings are read differently from those of b
    CHECK_FALSE(log_of(network).compares());
}
