#pragma once

#include <doctest/doctest.h>

namespace placedpar::test {

/// Returns an Approx that equals numbers which differ from `value` by less than `part` of the greater of the two.
/// doctest::Approx by itself also allows an absolute error of its epsilon. That is more than a whole compliance: 0
/// equals Approx(0.0086).epsilon(0.02). REQUIRES: value != 0, since the tolerance would be 0.
inline doctest::Approx nearly(double value, double part = 1e-9) {
    return doctest::Approx(value).epsilon(part).scale(0);
}

} // namespace placedpar::test
