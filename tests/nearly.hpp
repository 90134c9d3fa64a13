#pragma once

#include <doctest/doctest.h>

namespace placedpar::test {

/// Equals what differs from `value` by less than `part` of the greater of the two. doctest::Approx alone allows an
/// absolute error of its epsilon as well, which is more than the whole of a compliance: 0 equals
/// Approx(0.0086).epsilon(0.02). REQUIRES: value != 0, to which nothing is near by this measure.
inline doctest::Approx nearly(double value, double part = 1e-9) {
    return doctest::Approx(value).epsilon(part).scale(0);
}

} // namespace placedpar::test
