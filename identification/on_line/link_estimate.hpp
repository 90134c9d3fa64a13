#pragma once

#include "hydraulics/data/link.hpp"
#include "identification/flag.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace placedpar::identification {

struct DiagnosisSettings; // identification/on_line/settings.hpp

/// Estimates the compliance of one link from the best individuals of a genetic algorithm's generations. The algorithm
/// searches the compliances of a population set, that is, of links that share oil, together.
///
/// A transient is a run of samples during which the link's pressure changes enough to determine the compliance. The
/// estimate changes during transients and is frozen between them. It is settled when the best individuals of the last
/// `median_over` generations (settings.hpp), all within one transient, agree.
class LinkEstimate {
public:
    /// Holds everything that is needed to restore the object.
    struct State {
        std::vector<double> recent_in3_per_psi; ///< compliances of the last generations' best individuals, oldest first
        std::vector<double> settled_in3_per_psi; ///< one value for each of the last settled transients
        /// The standard error of the newest estimate, by least squares over its window of samples; 0: not computed yet.
        double standard_error_in3_per_psi = 0;
        double settled_error_in3_per_psi = 0; ///< standard error of the newest settled value
        double time_s = 0;                    ///< time of the sample that last changed the estimate
        double settled_time_s = 0;            ///< time of the sample that last changed the newest settled value
        double excitation_psi_per_s = 0;      ///< rms slope of the inlet pressure over the window
        bool excited = false; ///< whether the pressure changed enough at the newest sample (excitation_gate.hpp)
        bool fits = true; ///< whether the best individual had positive fitness; after answer(), whether least squares
                          ///< confirms the answer
        bool settled = false; ///< whether the estimate has settled in the present transient
        std::size_t generations_in_transient = 0;

        friend bool operator==(const State&, const State&) = default;
    };

    /// Settled values less than this time apart belong to one transient, since an operator's movements are seconds
    /// apart.
    static constexpr double transients_apart_s = 1;

    LinkEstimate() = default;
    explicit LinkEstimate(State state) : state_(std::move(state)) {}
    const State& state() const { return state_; }
    friend bool operator==(const LinkEstimate&, const LinkEstimate&) = default;

    /// Sets the rms slope of the pressure over the window. If the slope is too small to determine the compliance
    /// (excitation_gate.hpp), the transient ends.
    void excite(double rms_psi_per_s, const DiagnosisSettings& settings);
    void end_transient();
    /// Adds the compliance of a generation's best individual. `step_in3_per_psi` is the difference between the
    /// compliances of neighbouring codes.
    void add(double compliance_in3_per_psi, double time_s, double step_in3_per_psi, const DiagnosisSettings& settings);
    /// Takes the answer of a round of generations over many samples, and settles the estimate with it as a transient of
    /// its own. `confirmed` states whether least squares over the same samples agrees.
    void answer(double compliance_in3_per_psi, double standard_error_in3_per_psi, double time_s, bool confirmed);
    /// Sets the standard error, from least squares on the window. Call this function after the window's generations.
    void add_error(double standard_error_in3_per_psi);
    /// Records that no individual explains the window. The estimate stays unchanged.
    void nothing_fits() { state_.fits = false; }

    bool excited() const { return state_.excited; }
    /// Returns the median compliance of the recent best individuals; nullopt before the first generation.
    std::optional<double> compliance_in3_per_psi() const;
    /// Returns the least and the greatest compliance of the recent best individuals. REQUIRES: there is a compliance.
    std::pair<double, double> spread_in3_per_psi() const;
    /// Returns the reasons why the newest estimate may be wrong; empty before the first estimate.
    std::vector<Flag> flags(const DiagnosisSettings& settings) const;
    /// Returns the reasons why the newest settled value may be wrong. REQUIRES: there is a settled value.
    std::vector<Flag> settled_flags(const DiagnosisSettings& settings) const;
    std::optional<double> settled_in3_per_psi() const;
    /// Returns the median of the settled values of the last transients.
    std::optional<double> lasting_in3_per_psi() const;

private:
    State state_;
};

/// The estimates of the links of a population set.
struct SetEstimates {
    hydraulics::LinkSet set;
    std::size_t samples; ///< number of samples in the window, which the next generation will use
    std::uint64_t generations;
    std::span<const LinkEstimate> links; ///< in the order of links_of(); valid until the diagnosis changes
};

} // namespace placedpar::identification
