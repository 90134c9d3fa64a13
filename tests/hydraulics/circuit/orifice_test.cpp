#include "hydraulics/circuit/orifice.hpp"

#include <Eigen/Core>
#include <doctest/doctest.h>

#include <cmath>

using namespace placedpar;

namespace {

using EightDrops = Eigen::Array<double, 8, 1>;

// Whatever the compiler's target; the test hydraulics.avx512 compiles this for one that Eigen's own sqrt() fails.
using EightRoots = decltype(hydraulics::square_root(EightDrops()));
static_assert((Eigen::internal::evaluator<EightRoots>::Flags & Eigen::PacketAccessBit) || !EIGEN_MAX_ALIGN_BYTES,
              "one root after the other");

} // namespace

TEST_CASE("eight orifices at once have the bits of one after the other") {
    EightDrops drops;
    drops << -1, 0, 1e-300, 0.3, 2, 3, 1700, 4500;
    EightDrops flows = hydraulics::orifice_flow(7.3, drops);
    for (int i = 0; i < 8; ++i) {
        CAPTURE(drops[i]);
        CHECK(flows[i] == hydraulics::orifice_flow(7.3, drops[i]));
        CHECK(flows[i] == 7.3 * std::sqrt(drops[i] > 0 ? drops[i] : 0.0));
    }
}
