#include "identification/on_line/link_estimate.hpp"

#include "identification/circuit_problem.hpp"
#include "identification/statistics.hpp"

#include <algorithm>

namespace placedpar::identification {

using namespace hydraulics;

namespace {

/// The newest value comes in; the oldest leaves.
void push_bounded(std::vector<double>& values, double value, std::size_t limit) {
    if (values.size() >= limit)
        values.erase(values.begin(), values.end() - static_cast<std::ptrdiff_t>(limit - 1));
    values.push_back(value);
}

bool agree(const std::vector<double>& values, double step, double within) {
    auto [least, greatest] = std::ranges::minmax(values);
    // A difference of the search's resolution is no disagreement.
    return greatest - least <= std::max(within * median(values), 2 * step);
}

} // namespace

bool at_lower_bound(double compliance, double step) { return compliance <= 2 * step; }

bool at_upper_bound(double compliance, double step) {
    return compliance >= CircuitProblem::largest_in3_per_psi - 3 * step;
}

void LinkEstimate::excite(double rms_psi_per_s, const DiagnosisSettings& settings) {
    state_.excitation_psi_per_s = rms_psi_per_s;
    if (rms_psi_per_s < settings.gate_psi_per_s)
        end_transient();
    else
        state_.excited = true;
}

void LinkEstimate::end_transient() {
    state_.excited = false;
    state_.settled = false;
    state_.generations_in_transient = 0;
}

void LinkEstimate::add(double compliance, double time_s, double step, const DiagnosisSettings& settings) {
    state_.fits = true;
    state_.time_s = time_s;
    push_bounded(state_.recent_in3_per_psi, compliance, settings.median_over);
    ++state_.generations_in_transient;
    if (state_.generations_in_transient < settings.median_over ||
        !agree(state_.recent_in3_per_psi, step, settings.settled_within))
        return;
    double value = median(state_.recent_in3_per_psi);
    // Excitation that keeps crossing the gate makes no new transient.
    double since_s = time_s - state_.settled_time_s;
    bool same = !state_.settled_in3_per_psi.empty() && since_s >= 0 && since_s < transients_apart_s;
    if (state_.settled || same)
        state_.settled_in3_per_psi.back() = value;
    else
        push_bounded(state_.settled_in3_per_psi, value, kept_transients);
    state_.settled = true;
    state_.settled_time_s = time_s;
}

std::optional<double> LinkEstimate::compliance_in3_per_psi() const {
    if (state_.recent_in3_per_psi.empty())
        return std::nullopt;
    return median(state_.recent_in3_per_psi);
}

std::optional<double> LinkEstimate::settled_in3_per_psi() const {
    if (state_.settled_in3_per_psi.empty())
        return std::nullopt;
    return state_.settled_in3_per_psi.back();
}

std::optional<double> LinkEstimate::lasting_in3_per_psi() const {
    if (state_.settled_in3_per_psi.empty())
        return std::nullopt;
    return median(state_.settled_in3_per_psi);
}

} // namespace placedpar::identification
