#include "identification/flag.hpp"

#include "identification/circuit_problem.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace placedpar::identification {

std::string_view name_of(FlagKind kind) {
    constexpr std::array<std::string_view, 16> names{"lower_bound", "upper_bound", "no_excitation", "misfit",
                                                     "still_valve", "unsettled",   "inconsistent",  "halves",
                                                     "uncertain",   "offset",      "vacuum",        "frozen",
                                                     "falls",       "unconfirmed", "impossible",    "leak_or_offset"};
    return names[static_cast<std::size_t>(kind)];
}

bool at_lower_bound(double compliance, double step) { return compliance <= 2 * step; }

bool at_upper_bound(double compliance, double step) {
    return compliance >= CircuitProblem::largest_in3_per_psi - 3 * step;
}

Flag lower_bound_flag() {
    return {FlagKind::lower_bound, "at the lower bound of the search: the compliance that fits the record best "
                                   "is 0 or negative, which an offset of the spool's readings can cause"};
}

Flag upper_bound_flag() {
    return {FlagKind::upper_bound, fmt::format("at the upper bound of the search, {} in^3/psi: the true compliance may "
                                               "be larger",
                                               CircuitProblem::largest_in3_per_psi)};
}

Flag uncertain_flag(double compliance, double standard_error) {
    if (!std::isfinite(standard_error))
        return {FlagKind::uncertain,
                "uncertain: the record does not determine this compliance: check the readings, the spool, the "
                "units and the machine's constants"};
    double share = standard_error / compliance;
    std::string size = share < 1 ? fmt::format("{:.0f} %", 100 * share) : "as large as the compliance";
    return {FlagKind::uncertain,
            fmt::format("uncertain: the standard error is {}, more than {:.0f} %: check the spool, the units and "
                        "the machine's constants",
                        size, 100 * uncertain_share)};
}

std::optional<Flag> unconfirmed_flag(double compliance, const LeastSquares& reference, std::string_view samples) {
    constexpr double share = 0.1, errors = 2;
    const double least = reference.compliance_in3_per_psi;
    if (!std::isfinite(reference.standard_error))
        return Flag{FlagKind::unconfirmed,
                    fmt::format("unconfirmed: least squares over {} finds no compliance", samples)};
    if (std::abs(compliance - least) + errors * reference.standard_error <= share * least)
        return std::nullopt;
    return Flag{FlagKind::unconfirmed,
                fmt::format("unconfirmed: least squares over {} finds {:.5f} +- {:.5f} in^3/psi, so the answer "
                            "may be wrong by more than {:.0f} %",
                            samples, least, reference.standard_error, 100 * share)};
}

} // namespace placedpar::identification
