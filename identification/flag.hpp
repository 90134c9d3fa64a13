#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace placedpar::identification {

/// A reason why an identified compliance may be wrong. Users get it as a warning beside the compliance.
enum class FlagKind : unsigned char {
    lower_bound,   ///< the answer is at the search's lower bound
    upper_bound,   ///< the answer is at the search's upper bound
    no_excitation, ///< the pressure hardly changes
    misfit, ///< even the best individual leaves too great an error of the flows: above the root of the fitness's bias
    still_valve,   ///< the valve reading never changes
    unsettled,     ///< the best individuals of the last generations disagree
    inconsistent,  ///< searches with different sets of links found different compliances of this link: cross-check 1 of
                   ///< thesis 3.3
    halves,        ///< the two halves of the samples disagree
    uncertain,     ///< the standard error exceeds uncertain_share of the compliance
    offset,        ///< the calibration found a spool offset, which may really be a leak
    vacuum,        ///< a pressure is below vacuum
    frozen,        ///< the pressure's reading stays constant, then jumps
    falls,         ///< the piston retracts while oil flows in
    unconfirmed,   ///< least squares finds another compliance, or a compliance with a large standard error
    impossible,    ///< physically impossible readings, such as single outliers
    leak_or_offset ///< the link has a leak or an offset; the record does not tell which
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

/// A compliance with a greater relative standard error is flagged as uncertain. With a standard error of 10 %, one
/// answer in three is wrong by more than 10 %. The limit is this project's choice.
inline constexpr double uncertain_share = 0.1;

/// These functions return whether an answer is at an end of the search's range: within two steps of the lower end, or
/// within three steps of the upper end. A step is the difference between the compliances of neighbouring codes. Such an
/// answer is suspect: a spool offset can make the data fit best at a compliance beyond the range, and the search then
/// stays at the range's end.
bool at_lower_bound(double compliance_in3_per_psi, double step_in3_per_psi);
bool at_upper_bound(double compliance_in3_per_psi, double step_in3_per_psi);

Flag lower_bound_flag();
Flag upper_bound_flag();
Flag uncertain_flag(double compliance_in3_per_psi, double standard_error_in3_per_psi);

/// Returns a flag if the result `reference` of least squares does not confirm the answer. The reference confirms an
/// answer if their distance, plus two standard errors of the reference, is at most 10 % of the reference. This project
/// chose these limits on simulated machines of all configurations. `samples` describes in words the samples from which
/// the reference was computed.
std::optional<Flag> unconfirmed_flag(double compliance_in3_per_psi, const LeastSquares& reference,
                                     std::string_view samples);

} // namespace placedpar::identification
