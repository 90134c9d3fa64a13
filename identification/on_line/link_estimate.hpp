#pragma once

#include "identification/flag.hpp"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace placedpar::identification {

struct DiagnosisSettings; // identification/on_line/settings.hpp

/// What a population set knows of the compliance of one of its links.
///
/// A transient is a run of samples during which the link's pressure moves enough to tell its compliance. The estimate
/// moves during transients and is frozen between them. It is settled when, within one transient, the best individuals
/// of the last generations agree.
class LinkEstimate {
public:
    /// All that a restart needs.
    struct State {
        std::vector<double> recent_in3_per_psi;  ///< of the best individuals, oldest first
        std::vector<double> settled_in3_per_psi; ///< one for each of the last transients that settled
        double standard_error_in3_per_psi = 0;   ///< of the newest, by least squares on its window; 0: none yet
        double settled_error_in3_per_psi = 0;    ///< of the newest settled value
        double time_s = 0;                       ///< of the sample that moved the estimate last
        double settled_time_s = 0;               ///< of the sample that moved the newest settled value
        double excitation_psi_per_s = 0;         ///< rms slope of the inlet pressure over the window
        bool excited = false;                    ///< the excitation is above the gate
        bool fits = true;                        ///< the best individual had positive fitness
        bool settled = false;                    ///< within this transient
        std::size_t generations_in_transient = 0;

        friend bool operator==(const State&, const State&) = default;
    };

    /// Settled values closer together than this belong to one transient; ours: an operator's movements are seconds
    /// apart.
    static constexpr double transients_apart_s = 1;

    LinkEstimate() = default;
    explicit LinkEstimate(State state) : state_(std::move(state)) {}
    const State& state() const { return state_; }
    friend bool operator==(const LinkEstimate&, const LinkEstimate&) = default;

    /// Tells it the excitation of the window; below the gate the transient is over.
    void excite(double rms_psi_per_s, const DiagnosisSettings& settings);
    void end_transient();
    /// The best individual of a generation; `step` is the resolution of the search.
    void add(double compliance_in3_per_psi, double time_s, double step_in3_per_psi, const DiagnosisSettings& settings);
    /// What the noise of the window leaves uncertain, by least squares, after its generations.
    void add_error(double standard_error_in3_per_psi);
    /// No individual explains the window: nothing is added.
    void nothing_fits() { state_.fits = false; }

    bool excited() const { return state_.excited; }
    /// Median of the recent best; none before the first generation.
    std::optional<double> compliance_in3_per_psi() const;
    /// Of those: the least and the greatest. REQUIRES: a compliance.
    std::pair<double, double> spread_in3_per_psi() const;
    /// Why the newest should not be believed as it stands; nothing before there is one.
    std::vector<Flag> flags(const DiagnosisSettings& settings) const;
    /// Why the newest settled value should not be. REQUIRES: there is one.
    std::vector<Flag> settled_flags(const DiagnosisSettings& settings) const;
    /// The newest settled value.
    std::optional<double> settled_in3_per_psi() const;
    /// Median over the last transients.
    std::optional<double> lasting_in3_per_psi() const;

private:
    State state_;
};

} // namespace placedpar::identification
