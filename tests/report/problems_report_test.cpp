#include "explore/problems.hpp"
#include "report/problems_report.hpp"
#include "text/user_error.hpp"

#include <boost/json.hpp>
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
    CHECK(lists(listed, "identified from a record of 20 samples of 5 numbers"));
    CHECK(lists(listed, "\n  rastrigin(dimensions = 20, bits = 16)      Rastrigin's function: "));
    CHECK(lists(listed, "\n  tour-lattice(rows = 5, columns = 4) "));
}

TEST_CASE("a problem is described by its string and its record") {
    CHECK(print_problem(all_problems(), "trap(blocks = 4)") ==
          "trap(blocks = 4)\ndeceptive traps: in each block, single bit changes lead away from the optimum\n"
          "maximised; the optimum is 20\nstring: 20 bits\n\nnumbers\n"
          "  blocks           int     default 10             1 .. 100000\n"
          "                               number of blocks in a string\n"
          "  size             int     default 5              2 .. 64\n"
          "                               number of bits in a block\n");
    CHECK_THROWS_WITH_AS(print_problem(all_problems(), "nk(bits = 3, k = 5)"),
                         "k = 5, but each bit in a string of 3 bits has only 2 neighbours", UserError);
}

TEST_CASE("the fields of a string have names, bits, bounds, and the resolution of equation 1.5") {
    std::string plant = print_problem(all_problems(), "plant"); // Table 5.1
    CHECK(lists(plant, "string: 37 bits\n\nfields\n"
                       "  d                 2 bits  1 .. 4 samples, in steps of 1\n"
                       "  alpha             7 bits  -1 .. 0.984375, in steps of 0.0156\n"));
    CHECK(lists(plant, "\n  b0                7 bits  0 .. 1.98438, in steps of 0.0156\n"));
    CHECK(
        lists(print_problem(all_problems(), "boom"), "  C_BOi            10 bits  0 .. 0.0999023 in^3/psi, in steps"));
    CHECK(lists(print_problem(all_problems(), "rastrigin"), // many similar variables in one row
                "\n  x_1 ... x_20     16 bits  -5.12 .. 5.11984, in steps of 0.000156\n"));
    CHECK_FALSE(lists(print_problem(all_problems(), "tour-circle"), "fields"));
    boost::json::object machine = problem_json(all_problems(), "plant");
    CHECK(machine["fields"].as_array().size() == 6);
    CHECK(machine["fields"].at(1).at("step") == 1.0 / 64);
}

TEST_CASE("the JSON document has the same description") {
    boost::json::object tour = problem_json(all_problems(), "tour-random(cities = 9)");
    CHECK(tour["goal"] == "minimise");
    CHECK(tour["optimum"].is_null());
    CHECK(tour["bits"] == 9 * 64);
    CHECK(tour["numbers"].as_array().size() == 2);
    CHECK(problems_json(all_problems()).size() == all_problems().names().size());
}
