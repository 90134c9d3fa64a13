#include "identification/on_line/link_estimate.hpp"

#include "identification/on_line/settings.hpp"
#include "text/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace placedpar::identification {

namespace {

/// Appends the value. Drops the oldest values, so that at most `limit` values remain.
void push_bounded(std::vector<double>& values, double value, std::size_t limit) {
    if (values.size() >= limit)
        values.erase(values.begin(), values.end() - static_cast<std::ptrdiff_t>(limit - 1));
    values.push_back(value);
}

bool agree(const std::vector<double>& values, double their_median, double step, double within) {
    auto [least, greatest] = std::ranges::minmax(values);
    // Values that differ by at most twice the search's resolution always count as equal.
    return greatest - least <= std::max(within * their_median, 2 * step);
}

std::vector<Flag> flags_of(double compliance, double standard_error, const DiagnosisSettings& settings) {
    if (at_lower_bound(compliance, settings.step_in3_per_psi()))
        return {lower_bound_flag()};
    if (at_upper_bound(compliance, settings.step_in3_per_psi()))
        return {upper_bound_flag()};
    if (standard_error > uncertain_share * compliance)
        return {uncertain_flag(compliance, standard_error)};
    return {};
}

} // namespace

void LinkEstimate::excite(double rms_psi_per_s, const DiagnosisSettings& settings) {
    state_.excitation_psi_per_s = rms_psi_per_s;
    if (settings.gate.opens(rms_psi_per_s, compliance_in3_per_psi()))
        state_.excited = true;
    else
        end_transient();
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
    if (state_.generations_in_transient < settings.median_over)
        return;
    const double value = median(state_.recent_in3_per_psi);
    if (!agree(state_.recent_in3_per_psi, value, step, settings.settled_within))
        return;
    // The pressure may change too slowly for a moment, which ends a transient. Therefore a value that settles soon
    // after the last settled value belongs to the same transient, and replaces the last value.
    double since_s = time_s - state_.settled_time_s;
    bool same = !state_.settled_in3_per_psi.empty() && since_s >= 0 && since_s < transients_apart_s;
    if (state_.settled || same)
        state_.settled_in3_per_psi.back() = value;
    else
        push_bounded(state_.settled_in3_per_psi, value, kept_transients);
    state_.settled = true;
    state_.settled_time_s = time_s;
}

void LinkEstimate::answer(double compliance, double standard_error, double time_s, bool confirmed) {
    state_.excited = true;
    state_.fits = confirmed;
    state_.time_s = time_s;
    state_.recent_in3_per_psi = {compliance};
    state_.standard_error_in3_per_psi = standard_error;
    if (!confirmed)
        return;
    push_bounded(state_.settled_in3_per_psi, compliance, kept_transients);
    state_.settled_error_in3_per_psi = standard_error;
    state_.settled_time_s = time_s;
}

void LinkEstimate::add_error(double standard_error) {
    state_.standard_error_in3_per_psi = standard_error;
    if (state_.settled)
        state_.settled_error_in3_per_psi = standard_error;
}

std::pair<double, double> LinkEstimate::spread_in3_per_psi() const {
    auto [least, greatest] = std::ranges::minmax(state_.recent_in3_per_psi);
    return {least, greatest};
}

std::vector<Flag> LinkEstimate::flags(const DiagnosisSettings& settings) const {
    const auto compliance = compliance_in3_per_psi();
    if (!compliance)
        return {};
    std::vector<Flag> flags = flags_of(*compliance, state_.standard_error_in3_per_psi, settings);
    if (!state_.fits)
        flags.push_back({FlagKind::misfit,
                         "no individual explains the flow: check the areas, the machine's constants and the "
                         "configuration"});
    if (auto [least, greatest] = spread_in3_per_psi();
        !agree(state_.recent_in3_per_psi, *compliance, settings.step_in3_per_psi(), settings.settled_within))
        flags.push_back(
            {FlagKind::unsettled, fmt::format("not settled: the best individuals of the last generations lie between "
                                              "{:.5f} and {:.5f} in^3/psi",
                                              least, greatest)});
    return flags;
}

std::vector<Flag> LinkEstimate::settled_flags(const DiagnosisSettings& settings) const {
    return flags_of(*settled_in3_per_psi(), state_.settled_error_in3_per_psi, settings);
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
