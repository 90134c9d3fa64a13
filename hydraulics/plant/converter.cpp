#include "hydraulics/plant/converter.hpp"

#include "hydraulics/plant/requirement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace placedpar::hydraulics {

double Converter::step() const { return bits == 0 ? 0 : std::ldexp(range, -bits); }

double Converter::operator()(double value) const { return bits == 0 ? value : std::nearbyint(value / step()) * step(); }

double Converter::limited(double value, double least) const {
    return std::clamp((*this)(value), least, least + range - step());
}

int bits_of(const Parameters& parameters, std::string_view name) {
    double bits = parameters[name];
    if (!(bits >= 0 && bits <= 32 && bits == std::floor(bits)))
        throw UnfitScenario(fmt::format("{} is {}, expected a whole number from 0 to 32", name, bits));
    return static_cast<int>(bits);
}

} // namespace placedpar::hydraulics
