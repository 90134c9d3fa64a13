#include "text/user_error.hpp"
#include "workbench/problems.hpp"
#include "workbench/problems_report.hpp"

#include <doctest/doctest.h>

using namespace placedpar;

namespace {

const ProblemRegistry& all_problems() {
    static const ProblemRegistry problems = known_problems(1);
    return problems;
}

bool lists(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

} // namespace

TEST_CASE("every problem is listed, with its numbers or its record") {
    std::string listed = print_problems(all_problems());
    CHECK(listed.starts_with("problems\n"));
    CHECK(lists(listed, "\n  boom "));
    CHECK(lists(listed, "identified over a record of 20 samples of 5 numbers"));
    CHECK(lists(listed, "\n  rastrigin(dimensions = 20, bits = 16)      Rastrigin's function: "));
    CHECK(lists(listed, "\n  tour-lattice(rows = 5, columns = 4) "));
}

TEST_CASE("a problem is described by what is searched for, and over what") {
    CHECK(print_problem(all_problems(), "trap(blocks = 4)") ==
          "trap(blocks = 4)\ndeceptive traps: blocks where each bit by itself leads away\n"
          "maximised; the optimum is 20\nstring: 20 bits\n\nnumbers\n"
          "  blocks           int     default 10             1 .. 100000\n"
          "                               in a string\n"
          "  size             int     default 5              2 .. 64\n"
          "                               of a block, in bits\n");
    CHECK(lists(print_problem(all_problems(), "rastrigin"), "parameters: x_1, x_2, ..., x_20\n"));
    CHECK(lists(print_problem(all_problems(), "boom"), "parameters: C_BOi in^3/psi\n"));
    CHECK_THROWS_WITH_AS(print_problem(all_problems(), "nk(bits = 3, k = 5)"),
                         "k = 5, but a bit of 3 has only 2 neighbours", UserError);
}

TEST_CASE("for machines the same") {
    boost::json::object tour = problem_json(all_problems(), "tour-random(cities = 9)");
    CHECK(tour["goal"] == "minimise");
    CHECK(tour["optimum"].is_null());
    CHECK(tour["bits"] == 9 * 64);
    CHECK(tour["numbers"].as_array().size() == 2);
    CHECK(problems_json(all_problems()).size() == all_problems().names().size());
}
