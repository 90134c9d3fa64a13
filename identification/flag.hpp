#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace placedpar::identification {

/// Names a reason why a compliance may be wrong.
enum class FlagKind : unsigned char {
    lower_bound,   ///< the answer is at the search's lower bound
    upper_bound,   ///< the answer is at the search's upper bound
    no_excitation, ///< the pressure hardly changes
    misfit,        ///< the best individual's flow error exceeds the square root of the bias of the fitness
    still_valve,   ///< the valve reading never changes
    unsettled,     ///< the best individuals of the last generations disagree
    inconsistent,  ///< the sets of links that were searched apart disagree: cross-check 1 of thesis 3.3
    halves,        ///< the two halves of the samples disagree
    uncertain,     ///< the relative standard error is too large
    offset,        ///< the calibration found a spool offset, which may really be a leak
    vacuum,        ///< a pressure is below vacuum
    frozen,        ///< the pressure's reading stays constant, then jumps
    falls,         ///< the piston retracts while oil flows in
    unconfirmed,   ///< least squares finds another compliance, or a compliance with a large standard error
    impossible,    ///< physically impossible readings, such as single outliers
    leak_or_offset ///< a leak or an offset; the record does not tell which
};

/// Returns the name used in machine-readable results, such as "lower_bound".
std::string_view name_of(FlagKind);

struct Flag {
    FlagKind kind;
    std::string text; ///< a sentence for the user, with the figures
};

/// The result of least squares on a set of samples.
struct LeastSquares {
    double compliance_in3_per_psi = 0;
    /// Infinite if the samples do not determine the compliance.
    double standard_error = std::numeric_limits<double>::infinity();

    friend bool operator==(const LeastSquares&, const LeastSquares&) = default;
};

/// The relative standard error above which a compliance is flagged. We chose this value: with a standard error of 10 %,
/// one answer in three is wrong by more than 10 %.
inline constexpr double uncertain_share = 0.1;

/// Return whether an answer is within two steps of the lower end of the search's range, or within three steps of the
/// upper end. A step is the
/// difference between neighbouring codes. A spool offset can make the data fit best at a compliance that is negative or
/// beyond the range. The search then stays at the end of its range.
bool at_lower_bound(double compliance_in3_per_psi, double step_in3_per_psi);
bool at_upper_bound(double compliance_in3_per_psi, double step_in3_per_psi);

Flag lower_bound_flag();
Flag upper_bound_flag();
Flag uncertain_flag(double compliance_in3_per_psi, double standard_error_in3_per_psi);

/// Returns a flag unless the answer is confirmed. The answer is confirmed if its distance from the reference, plus two
/// standard errors of the reference, is at most 10 % of the reference. We chose these limits, and tuned them on
/// simulated machines of all configurations. `samples` describes the samples of the reference in words.
std::optional<Flag> unconfirmed_flag(double compliance_in3_per_psi, const LeastSquares& reference,
                                     std::string_view samples);

} // namespace placedpar::identification
