#pragma once

namespace placedpar::hydraulics {

constexpr double square(double x) { return x * x; }

} // namespace placedpar::hydraulics
