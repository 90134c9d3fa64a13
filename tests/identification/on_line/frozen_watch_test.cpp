#include "identification/on_line/frozen_watch.hpp"

#include "hydraulics/data/frozen_run.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <span>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

/// Returns the readings at which the watch reports a frozen sensor.
std::vector<std::size_t> told(std::span<const double> psi, double least_jump = least_jump_psi,
                              std::size_t fewest = fewest_frozen(0.02)) {
    FrozenWatch watch;
    std::vector<std::size_t> told;
    for (std::size_t i = 0; i < psi.size(); ++i)
        if (watch.take(psi[i], least_jump, fewest))
            told.push_back(i);
    return told;
}

} // namespace

TEST_CASE("a frozen sensor is reported at the reading after its jump") {
    CHECK(told(std::vector<double>{100, 130, 160, 160, 160, 160, 160, 310, 340}) == std::vector<std::size_t>{8});
    CHECK(told(std::vector<double>{100, 130, 160, 160, 160, 160, 310, 340}).empty()); // four equal readings
    CHECK(told(std::vector<double>{100, 100, 100, 100, 100, 150, 210}).empty());      // a rest that ends
    CHECK(told(std::vector<double>{5, 5.1, 5.2, 5.2, 5.2, 5.2, 5.2, 5.8, 5.9}, least_jump_deg) ==
          std::vector<std::size_t>{8});
}

TEST_CASE("a sensor counts as frozen after a tenth of a second at any rate, and after five readings at least") {
    CHECK(fewest_frozen(0.1) == 5);
    CHECK(fewest_frozen(0.02) == 5);
    CHECK(fewest_frozen(0.001) == 100);
    std::vector<double> held; // measured fifty times a second, logged a thousand times
    for (std::size_t i = 0; i < 400; ++i)
        held.push_back(1000 + 60.0 * static_cast<double>(i / 20));
    CHECK(told(held, least_jump_psi, fewest_frozen(0.001)).empty());
    std::vector<double> frozen(100, 1000);
    frozen.insert(frozen.end(), {1100, 1101});
    CHECK(told(frozen, least_jump_psi, fewest_frozen(0.001)) == std::vector<std::size_t>{101});
}

TEST_CASE("reading by reading, FrozenWatch agrees with frozen_run() over a record") {
    RandomStream random(1, "pressures");
    int frozen = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<double> psi{1000};
        while (psi.size() < 40)
            psi.push_back(random.uniform() < 0.6 ? psi.back() : psi.back() + std::round(150 * random.uniform()));
        auto run = frozen_run(psi, least_jump_psi, fewest_frozen(0.02));
        frozen += run.has_value();
        CHECK(told(psi).empty() == !run);
        if (run)
            CHECK(told(psi).front() == run->last + 1);
    }
    CHECK(frozen > 200);
    CHECK(frozen < 1800);
}
