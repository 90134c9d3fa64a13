#include "gaprocs/problem_registry.hpp"
#include "tests/gaprocs/line_problem.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace placedpar;

static_assert(Searchable<LineProblem>);
static_assert(!Searchable<int>);

TEST_CASE("a problem is found by its name, with its record") {
    ProblemRegistry registry;
    registry.add("line", make_search_problem(LineProblem{}), line_record(3));
    registry.add("another", make_search_problem(LineProblem{}), {});
    CHECK(registry.find("line").record() == line_record(3));
    CHECK(registry.find("line").problem()->bits() == 8);
    CHECK(registry.find("line").problem()->true_parameters().empty());
    CHECK(registry.names() == std::vector<std::string>{"another", "line"});
    CHECK_THROWS_WITH_AS(registry.find("lime"),
                         "unknown search problem 'lime'; known: another, line; did you mean \"line\"?", UserError);
}

TEST_CASE("an empty name, a repeated name and a wrong record are refused with a reason") {
    ProblemRegistry registry;
    auto problem = make_search_problem(LineProblem{});
    CHECK_THROWS_WITH_AS(registry.add("", problem, {}), "a search problem needs a name", std::invalid_argument);
    CHECK_THROWS_WITH_AS(registry.add("line", nullptr, {}), "search problem 'line': the problem is a null pointer",
                         std::invalid_argument);
    CHECK_THROWS_WITH_AS(registry.add("line", problem, {{1, 2}, {1}}),
                         "search problem 'line': sample 1 has 1 number, expected 2", std::invalid_argument);
    registry.add("line", problem, {});
    CHECK_THROWS_WITH_AS(registry.add("line", problem, {}), "a search problem named 'line' exists already",
                         std::invalid_argument);
}

TEST_CASE("a family of problems with records makes each record once for each set of numbers") {
    int made = 0;
    ProblemFamily lines{{"lines", "", {{"samples", 3, 1, 9, true}}},
                        [](const std::vector<double>&) { return make_search_problem(LineProblem{}); },
                        [&](const std::vector<double>& numbers) {
                            auto samples = static_cast<std::size_t>(numbers[0]);
                            return RecordToMake{samples, [&made, samples] { return ++made, line_record(samples); }};
                        }};
    ProblemRegistry registry;
    registry.add(lines);
    CHECK(registry.find("lines").samples() == 3);
    CHECK(registry.find("lines(5)").samples() == 5);
    CHECK(made == 0);
    CHECK(registry.find("lines(5)").record() == line_record(5));
    CHECK(registry.find("lines(samples = 5)").record() == line_record(5));
    CHECK(made == 1);
}

TEST_CASE("a record that takes time to make is made once, when it is first read") {
    int made = 0;
    auto make = [&] {
        ++made;
        return line_record(3);
    };
    ProblemRegistry registry;
    registry.add_to_make("line", make_search_problem(LineProblem{}), {3, make});
    const RecordedProblem& line = registry.find("line");
    CHECK(line.problem()->bits() == 8);
    CHECK(line.samples() == 3);
    CHECK(made == 0);
    CHECK(line.record() == line_record(3));
    CHECK(registry.find("line").record() == line_record(3));
    CHECK(made == 1);
}

TEST_CASE("a made record whose number of samples differs from the promised one is refused") {
    ProblemRegistry registry;
    auto problem = make_search_problem(LineProblem{});
    registry.add_to_make("short", problem, {3, [] { return line_record(2); }});
    CHECK_THROWS_WITH_AS(registry.find("short").record(),
                         "RecordToMake::samples is 3, but the number of samples that make() returned is 2: the two "
                         "numbers must be equal",
                         UserError);
    registry.add_to_make("narrow", problem, {1, [] { return std::vector<Sample>{{1}}; }});
    CHECK_THROWS_WITH_AS(registry.find("narrow").record(), "sample 0 has 1 number, expected 2", std::invalid_argument);
}
