#include "app/problems.hpp"

#include "gaprocs/kinds.hpp"
#include "gaprocs/search_problem.hpp"
#include "hydraulics/boom_problem.hpp"
#include "hydraulics/boom_record.hpp"
#include "netlist/csp_kinds.hpp"
#include "runtime/random.hpp"

namespace placedpar {

namespace {

/// The boom of chapter 3 in the motion of scenario A, measured with the lowest of the noise levels studied.
void add_boom(ProblemRegistry& problems, std::uint64_t seed) {
    BoomScenario scenario;
    RandomStream noise(seed, "record of the boom");
    auto record = boom_record(scenario, low_noise, [&] { return noise.uniform(); });
    problems.add("boom", make_search_problem(BoomProblem(scenario.flow, scenario.machine.inlet_compliance_in3_per_psi)),
                 std::move(record));
}

} // namespace

ProblemRegistry known_problems(std::uint64_t seed) {
    ProblemRegistry problems;
    add_boom(problems, seed);
    return problems;
}

Catalogue known_kinds(const ProblemRegistry& problems) {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    add_genetic_algorithm_kinds(catalogue, problems);
    return catalogue;
}

} // namespace placedpar
