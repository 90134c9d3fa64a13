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

/// The readings at which the watch speaks.
std::vector<std::size_t> told(std::span<const double> psi, double least_jump = least_jump_psi) {
    FrozenWatch watch;
    std::vector<std::size_t> told;
    for (std::size_t i = 0; i < psi.size(); ++i)
        if (watch.take(psi[i], least_jump))
            told.push_back(i);
    return told;
}

} // namespace

TEST_CASE("a frozen sensor is told at the reading after its jump") {
    CHECK(told(std::vector<double>{100, 130, 160, 160, 160, 160, 160, 310, 340}) == std::vector<std::size_t>{8});
    CHECK(told(std::vector<double>{100, 130, 160, 160, 160, 160, 310, 340}).empty()); // four equal readings
    CHECK(told(std::vector<double>{100, 100, 100, 100, 100, 150, 210}).empty());      // a rest that ends
    CHECK(told(std::vector<double>{5, 5.1, 5.2, 5.2, 5.2, 5.2, 5.2, 5.8, 5.9}, least_jump_deg) ==
          std::vector<std::size_t>{8});
}

TEST_CASE("sample by sample it finds what frozen_run finds in a record") {
    RandomStream random(1, "pressures");
    int frozen = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<double> psi{1000};
        while (psi.size() < 40)
            psi.push_back(random.uniform() < 0.6 ? psi.back() : psi.back() + std::round(150 * random.uniform()));
        auto run = frozen_run(psi, least_jump_psi);
        frozen += run.has_value();
        CHECK(told(psi).empty() == !run);
        if (run)
            CHECK(told(psi).front() == run->last + 1);
    }
    CHECK(frozen > 200);
    CHECK(frozen < 1800);
}
