#pragma once

namespace placedpar {

constexpr double square(double x) { return x * x; }

} // namespace placedpar
