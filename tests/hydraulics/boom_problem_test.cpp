#include "gaprocs/search_problem.hpp"
#include "hydraulics/boom_orifices.hpp"
#include "hydraulics/boom_problem.hpp"

#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;

namespace {

BoomSample sample_of_section_8() {
    OrificeAreas areas = boom_orifices(0.24);
    return {1800, 1500, 32 * 0.5, areas.inlet_in2, areas.bypass_in2};
}

std::vector<double> values(const BoomSample& sample) {
    return {sample.inlet_psi, sample.inlet_slope_psi_per_s, sample.piston_flow_in3_per_s, sample.inlet_in2,
            sample.bypass_in2};
}

} // namespace

TEST_CASE("the error of eq. 3.8 at spool .24 in, 1800 psi, rising 1500 psi/s, piston .5 in/s, C .0086") {
    double error = boom_error_in3_per_s(0.0086, sample_of_section_8(), rounded_flow_constants);
    CHECK(std::abs(error - 2.0562) < 1e-4);
}

TEST_CASE("a pressure below the tank's gives no square root of a negative number") {
    BoomSample sample{10, 0, 0, 0.05, 0.05}; // P = 10 psi, tank 25: no bypass flow, all 175 are missed
    CHECK(boom_error_in3_per_s(0.0, sample, rounded_flow_constants) == 175);
}

TEST_CASE("the string is a natural binary number of 10 bits over 0 ... 0.1") {
    BoomProblem problem(rounded_flow_constants, 0.0086);
    auto compliance = [&](const char* text) { return problem.decode(Genome::from_string(text)).at(0); };
    CHECK(compliance("0000000000") == 0);
    CHECK(compliance("0000000001") == doctest::Approx(0.1 / 1024));
    CHECK(compliance("0001011000") == doctest::Approx(0.00859375)); // 88
    CHECK(compliance("1111111111") == doctest::Approx(0.1 * 1023 / 1024));
}

TEST_CASE("the problem through SearchProblem is the problem itself") {
    auto problem = make_search_problem(BoomProblem(rounded_flow_constants, 0.0086));
    CHECK(problem->bits() == 10);
    CHECK(problem->channels() == 5);
    CHECK(problem->parameter_names() == std::vector<std::string>{"C_BOi"});
    CHECK(problem->parameter_units() == std::vector<std::string>{"in^3/psi"});
    CHECK(problem->true_parameters() == std::vector<double>{0.0086});
    CHECK(make_search_problem(BoomProblem(rounded_flow_constants))->true_parameters().empty());

    Genome genome(10);
    genome.set_field(0, 10, 88);
    double direct = boom_error_in3_per_s(0.1 * 88 / 1024, sample_of_section_8(), rounded_flow_constants);
    CHECK(problem->error(genome, values(sample_of_section_8())) == direct);
}
