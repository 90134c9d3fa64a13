#include "experiments/chapter_3/kit/pressure_check.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <stdexcept>

using namespace placedpar;
using namespace placedpar::hydraulics;

TEST_CASE("the true compliance gives back the recorded pressure, half and twice do not") {
    BoomData data = measure({BoomPlant::simple}, 1);
    double truth = data.boom.inlet_compliance_in3_per_psi;
    for (AreasFrom from : {AreasFrom::spool, AreasFrom::servo}) {
        BoomModel model = model_of(data, from);
        CHECK(check_pressure(data, model, truth).rms_psi <= 4);
        CHECK(check_pressure(data, model, truth / 2).rms_psi >= 80);
        CHECK(check_pressure(data, model, truth * 2).rms_psi >= 80);
    }
}

TEST_CASE("the transient of scenario A: from .18 s on, a rise of 513 psi") {
    BoomData data = measure({BoomPlant::simple}, 1);
    auto check = check_pressure(data, model_of(data, AreasFrom::spool), 0.0086);
    CHECK(check.from_s == doctest::Approx(0.18));
    CHECK(check.until_s == doctest::Approx(0.66));
    CHECK(check.rise_psi == doctest::Approx(513).epsilon(0.01));
}

TEST_CASE("a record in which nothing opens is refused") {
    BoomMotion still{BoomPlant::simple};
    still.spool_desired_in = 0.15; // within the dead band
    BoomData data = measure(still, 1);
    CHECK_THROWS_WITH_AS(check_pressure(data, model_of(data, AreasFrom::spool), 0.0086),
                         "the record has no transient in which the inlet opens", UserError);
}
