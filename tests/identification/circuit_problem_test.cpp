#include "gaprocs/search_problem.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "identification/circuit_problem.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <array>
#include <stdexcept>

using namespace placedpar;
using namespace placedpar::hydraulics;

TEST_CASE("the string is a natural binary number of 10 bits over 0 ... 0.1") {
    CircuitProblem problem(boom_circuit(), rounded_flow_constants());
    auto compliance = [&](const char* text) { return problem.decode(Genome::from_string(text)).at(0); };
    CHECK(compliance("0000000000") == 0);
    CHECK(compliance("0000000001") == test::nearly(0.1 / 1024));
    CHECK(compliance("0001011000") == test::nearly(0.00859375)); // code 88
    CHECK(compliance("1111111111") == test::nearly(0.1 * 1023 / 1024));
}

TEST_CASE("a compliance may have any number of bits, and the first is worth half of the range") {
    for (std::size_t bits : {1u, 10u, 12u, 32u}) {
        CircuitProblem problem(boom_circuit(), rounded_flow_constants(), bits);
        CHECK(problem.bits() == bits);
        Genome half(bits);
        half.flip(0);
        CHECK(problem.decode(half).at(0) == 0.05);
    }
}

TEST_CASE("the SearchProblem interface gives the problem's own fitness") {
    auto problem = make_search_problem(CircuitProblem(boom_circuit(), rounded_flow_constants()));
    CHECK(problem->bits() == 10);
    CHECK(problem->channels() == 5);
    CHECK(problem->parameter_names() == std::vector<std::string>{"C_BOi"});
    CHECK(problem->parameter_units() == std::vector<std::string>{"in^3/psi"});
    CHECK(problem->true_parameters().empty());

    LinkSample sample{1800, 1500, 32 * 0.5, 0.065, 0.034};
    CircuitSample of_boom{0, 0, {sample}};
    Genome genome(10);
    genome.set_field(0, 10, 88);
    std::array compliance{0.1 * 88 / 1024};
    CHECK(problem->error(genome, of_boom.values()) ==
          circuit_error_in3_per_s<double>(boom_circuit(), compliance, of_boom.links, rounded_flow_constants(),
                                          InletFlow::absolute));
}

TEST_CASE("a circuit without links, or with more than four, is refused") {
    CHECK_THROWS_WITH_AS(CircuitProblem({}, rounded_flow_constants()), "a circuit has 1 to 4 junctions, not 0",
                         std::invalid_argument);
}
