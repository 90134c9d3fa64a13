#include "hydraulics/data/parameter_range.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace placedpar::hydraulics {

namespace {

// Endings of parameters' names. The values of these parameters are above 0 (`positive`), or 0 or above
// (`not_negative`).
constexpr auto positive = std::to_array<std::string_view>({
    ".orifice",
    ".relief",
    "flow.pump",
    "rounded.pump",
    "let_area",
    ".moment_arm",
    ".mass",
    ".friction_velocity",
    "let_compliance",
    "spool_lag",
    ".duration",
    ".period",
    ".integration_step",
    ".bulk_modulus",
    ".asked_flow",
    ".inlet_drop",
    ".bypass_drop",
    ".inlet_inertance",
    ".outlet_inertance",
    ".stribeck_velocity",
    "bristle_stiffness",
    "_range",
    ".drain_laminar",
    "_valve_share",
    "atmospheric_pressure",
    "cross_over.shift",
    "cross_over.release",
    "pipe.volume",
    "_length",
    "joystick.lag",
});
constexpr auto not_negative = std::to_array<std::string_view>({
    "damping",       ".friction",  "_ramp",        ".spool_at_rest", ".spool_desired", "_inlet_final", "_bypass_rest",
    "_bypass_final", "fault.leak", ".air",         ".dead_time",     ".ripple",        "_resistance",  ".breakaway",
    "_volume",       "_bits",      "pump.pistons", "pump.shaft",     ".seat",          ".least_flow",
});

bool ends_with_any(std::string_view name, const auto& endings) {
    return std::ranges::any_of(endings, [&](std::string_view ending) { return name.ends_with(ending); });
}

} // namespace

bool ParameterRange::contains(double value) const {
    return std::isfinite(value) && (least_included ? value >= least : value > least);
}

std::string ParameterRange::expected() const {
    if (std::isinf(least))
        return "a finite number";
    return least_included ? "0 or above" : "above 0";
}

ParameterRange range_of(std::string_view parameter) {
    if (ends_with_any(parameter, positive))
        return {0, false};
    if (ends_with_any(parameter, not_negative) || parameter.starts_with("noise."))
        return {0, true};
    return {};
}

} // namespace placedpar::hydraulics
