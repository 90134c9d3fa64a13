#include "hydraulics/circuit/cross_over.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string_view>

using namespace placedpar::hydraulics;

namespace {

constexpr CrossOverLimits limits{1000, 500, 20};
constexpr std::array<double, 9> pressures{0, 15, 30, 400, 520, 600, 1100, 1700, 2900};

/// Calls work(pressures) for every combination of the pressures.
void for_all_pressures(auto work) {
    for (double p12 : pressures)
        for (double p13 : pressures)
            for (double p22 : pressures)
                for (double p23 : pressures)
                    work(BranchPressures{p12, p13, p22, p23});
}

/// Returns where the surpluses go next (tank, boom, stick), from a table by where they go now and by P13 - P23.
char surplus(char now, double difference_psi) {
    const std::size_t band = difference_psi < -1000  ? 0
                             : difference_psi < -500 ? 1
                             : difference_psi <= 500 ? 2
                             : difference_psi > 1000 ? 4
                                                     : 3;
    return std::string_view(now == 't' ? "stttb" : now == 'b' ? "ttbbb" : "ssstt")[band];
}

Configuration expected(Configuration now, const BranchPressures& p) {
    const char letter = name_of(now), from = letter == 'a' ? 't' : letter == 'b' || letter == 'd' ? 'b' : 's';
    switch (surplus(from, p.p13_psi - p.p23_psi)) {
    case 'b': return p.p13_psi - p.p12_psi > (letter == 'b' ? 0 : 20) ? Configuration::b : Configuration::d;
    case 's': return p.p23_psi - p.p22_psi > (letter == 'c' ? 0 : 20) ? Configuration::c : Configuration::e;
    default: return Configuration::a;
    }
}

/// Exchanges the branches.
Configuration mirrored(Configuration configuration) {
    constexpr std::array<Configuration, 5> other{Configuration::a, Configuration::c, Configuration::b, Configuration::e,
                                                 Configuration::d};
    return other[static_cast<std::size_t>(configuration)];
}

} // namespace

TEST_CASE("the rule of 2.4 gives the table's configuration for every state and every order of pressures") {
    for (Configuration now : all_configurations)
        for_all_pressures([&](const BranchPressures& p) {
            if (next_configuration(now, p, limits) != expected(now, p))
                FAIL("from ", name_of(now), " at ", p.p12_psi, " ", p.p13_psi, " ", p.p22_psi, " ", p.p23_psi);
        });
}

TEST_CASE("exchanging the branches exchanges b with c and d with e") {
    for (Configuration now : all_configurations)
        for_all_pressures([&](const BranchPressures& p) {
            const BranchPressures other{p.p22_psi, p.p23_psi, p.p12_psi, p.p13_psi};
            if (next_configuration(mirrored(now), other, limits) != mirrored(next_configuration(now, p, limits)))
                FAIL("from ", name_of(now));
        });
}
