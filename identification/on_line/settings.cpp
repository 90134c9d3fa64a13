#include "identification/on_line/settings.hpp"

#include "identification/circuit_problem.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

void require(bool good, const char* what, double value, const char* right) {
    if (!good)
        throw UserError(fmt::format("{} is {}, expected {}", what, value, right));
}

} // namespace

SearchSettings service_search() {
    SearchSettings search;
    search.elite = 1;
    return search;
}

double DiagnosisSettings::step_in3_per_psi() const {
    return CircuitProblem::largest_in3_per_psi / static_cast<double>(1u << bits);
}

void DiagnosisSettings::validate() const {
    search.validate();
    require(bits >= 4 && bits <= 16, "the number of bits of a compliance", static_cast<double>(bits), "4 to 16");
    require(gate.slope_psi_per_s >= 0, "the threshold of excitation", gate.slope_psi_per_s, "0 psi/s or more");
    require(median_over >= 1, "the number of generations of the median", static_cast<double>(median_over), "1 or more");
    require(settled_within > 0, "the width of a settled estimate", settled_within, "more than 0");
    require(inconsistent_over > 0, "the spread of inconsistent estimates", inconsistent_over, "more than 0");
    require(stale_after_s > 0, "the age of a stale estimate", stale_after_s, "more than 0 s");
}

} // namespace placedpar::identification
