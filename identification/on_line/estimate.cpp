#include "identification/on_line/estimate.hpp"

#include "hydraulics/circuit/circuit_problem.hpp"

#include <algorithm>

namespace placedpar::monitor {

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
    // The resolution is no disagreement.
    return greatest - least <= std::max(within * median(values), 2 * step);
}

} // namespace

double median(std::vector<double> values) {
    auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    if (values.size() % 2 == 1)
        return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

bool at_lower_bound(double compliance, double step) { return compliance <= 2 * step; }

bool at_upper_bound(double compliance, double step) {
    return compliance >= CircuitProblem::largest_in3_per_psi - 3 * step;
}

void Estimate::excite(double rms_psi_per_s, const DiagnosisSettings& settings) {
    state_.excitation_psi_per_s = rms_psi_per_s;
    if (rms_psi_per_s < settings.gate_psi_per_s)
        end_transient();
    else
        state_.excited = true;
}

void Estimate::end_transient() {
    state_.excited = false;
    state_.settled = false;
    state_.generations_in_transient = 0;
}

void Estimate::add(double compliance, double time_s, double step, const DiagnosisSettings& settings) {
    state_.fits = true;
    state_.time_s = time_s;
    push_bounded(state_.recent_in3_per_psi, compliance, settings.median_over);
    ++state_.generations_in_transient;
    if (state_.generations_in_transient < settings.median_over ||
        !agree(state_.recent_in3_per_psi, step, settings.settled_within))
        return;
    double value = median(state_.recent_in3_per_psi);
    // Excitation that comes and goes about the gate makes no new transient.
    double since_s = time_s - state_.settled_time_s;
    bool same = !state_.settled_in3_per_psi.empty() && since_s >= 0 && since_s < transients_apart_s;
    if (state_.settled || same)
        state_.settled_in3_per_psi.back() = value;
    else
        push_bounded(state_.settled_in3_per_psi, value, kept_transients);
    state_.settled = true;
    state_.settled_time_s = time_s;
}

std::optional<double> Estimate::compliance_in3_per_psi() const {
    if (state_.recent_in3_per_psi.empty())
        return std::nullopt;
    return median(state_.recent_in3_per_psi);
}

std::optional<double> Estimate::settled_in3_per_psi() const {
    if (state_.settled_in3_per_psi.empty())
        return std::nullopt;
    return state_.settled_in3_per_psi.back();
}

std::optional<double> Estimate::lasting_in3_per_psi() const {
    if (state_.settled_in3_per_psi.empty())
        return std::nullopt;
    return median(state_.settled_in3_per_psi);
}

} // namespace placedpar::monitor
