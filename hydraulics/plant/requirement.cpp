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

} // namespace placedpar::hydraulics
