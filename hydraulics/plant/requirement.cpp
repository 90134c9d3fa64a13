#include "hydraulics/plant/requirement.hpp"

#include <fmt/format.h>

#include <cmath>

namespace placedpar::hydraulics {

void Requirement::refuse(std::string_view what, double value, std::string_view expected) const {
    throw UnfitScenario(fmt::format("{}: {} is {}, expected {}", of, what, value, expected));
}

void Requirement::positive(std::string_view what, double value) const {
    if (!(value > 0 && std::isfinite(value)))
        refuse(what, value, "above 0");
}

void Requirement::not_negative(std::string_view what, double value) const {
    if (!(value >= 0 && std::isfinite(value)))
        refuse(what, value, "0 or above");
}

void Requirement::finite(std::string_view what, double value) const {
    if (!std::isfinite(value))
        refuse(what, value, "a finite number");
}

void Requirement::share(std::string_view what, double value) const {
    if (!(value > 0 && value < 1))
        refuse(what, value, "above 0 and below 1");
}

void Requirement::kept_whole(double duration_s, double integration_step_s) const {
    constexpr double most_steps = 2e6;
    if (duration_s > most_steps * integration_step_s)
        throw UnfitScenario(fmt::format(
            "{}: the duration is {} s, expected at most {:g} s, which are {:.0f} integration steps of {:g} s", of,
            duration_s, most_steps * integration_step_s, most_steps, integration_step_s));
}

} // namespace placedpar::hydraulics
