#include "hydraulics/data/units.hpp"
#include "tests/nearly.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

double factor(std::string_view name) {
    const Unit* unit = unit_named(name);
    REQUIRE_MESSAGE(unit, name);
    return unit->factor;
}

constexpr int quantities = static_cast<int>(Quantity::resistance) + 1;

} // namespace

TEST_CASE("unit conversions agree with the thesis and with tables") {
    CHECK(1 / factor("Pa") == doctest::Approx(6894.757));                 // NIST SP 811
    CHECK(13996 * factor("kPa") == doctest::Approx(2030).epsilon(1e-4));  // Table 2.6
    CHECK(819.5 * factor("cm^3/s") == doctest::Approx(50).epsilon(3e-4)); // Table 2.6
    CHECK(0.696 * factor("cm") == test::nearly(0.2741, 1e-3));            // Table 2.6
    CHECK(1 / factor("m^3/Pa") == test::nearly(2.37672e-9, 1e-5));
    CHECK(1 / factor("m^3/(s m^2 Pa^0.5)") == test::nearly(3.0590e-4, 1e-4));
    CHECK(172.1 * factor("L/min") == doctest::Approx(175).epsilon(1e-3));
    CHECK(220 * factor("kN") == doctest::Approx(49458).epsilon(1e-4)); // 1 lbf = 4.4482216 N
    CHECK(175.127 * factor("kg") == doctest::Approx(1).epsilon(1e-5)); // 386.09 lb
    CHECK(175.127 * factor("N s/m") == doctest::Approx(1).epsilon(1e-5));
    CHECK(175.127 * factor("N/m") == doctest::Approx(1).epsilon(1e-5));
    CHECK(1 / factor("Pa s^2/m^3") == doctest::Approx(6894.757 / 16.387064e-6).epsilon(1e-6));
    CHECK(16.387064 * factor("cm^3") == doctest::Approx(1).epsilon(1e-6));
    CHECK(std::acos(-1.0) * factor("rad") == doctest::Approx(180));
    CHECK(20 * factor("ms") == doctest::Approx(0.020));
    CHECK(350 * factor("mV") == doctest::Approx(0.35));
}

TEST_CASE("the first unit of every quantity has factor 1, and no two units have the same name") {
    std::string all;
    for (int i = 0; i < quantities; ++i) {
        auto quantity = static_cast<Quantity>(i);
        auto units = units_of(quantity);
        REQUIRE(!units.empty());
        CHECK(units.front().factor == 1);
        CHECK(!name_of(quantity).empty());
        for (const Unit& unit : units) {
            CHECK(unit.factor > 0);
            CHECK(unit_named(unit.name)->quantity == quantity);
            CHECK(unit_named(unit.name)->factor == unit.factor);
        }
    }
    CHECK(unit_named("furlong") == nullptr);
    CHECK(unit_named("PSI") == nullptr);
}

TEST_CASE("units are listed for messages") {
    CHECK(list_units(Quantity::pressure) == "psi, Pa, kPa, MPa or bar");
    CHECK(list_units(Quantity::angle) == "deg or rad");
    CHECK(list_units(Quantity::rate) == "1/s");
}
