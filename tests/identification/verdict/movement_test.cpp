#include "identification/verdict/movement.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

using namespace placedpar;
using namespace placedpar::hydraulics;
using namespace placedpar::identification;

namespace {

JunctionSamples boom_at(double psi, double inlet_in2) {
    return {{psi, 0, inlet_in2 > 0 ? 30.0 : 0.0, inlet_in2, 0.03}};
}

class Stream {
public:
    /// Returns the number of movements that ended.
    std::size_t feed(std::size_t samples, bool open) { return feed_inlet(samples, open ? 0.09 : 0); }
    std::size_t feed_inlet(std::size_t samples, double inlet_in2) {
        std::size_t over = 0;
        for (std::size_t i = 0; i < samples; ++i)
            if (movement.take(circuit, fitted_flow_constants(), boom_at(++psi, inlet_in2))) {
                ++over;
                last = movement.finish();
            }
        return over;
    }
    Movement movement;
    MovementSamples last;
    Circuit circuit = boom_circuit();
    double psi = 1000;
};

} // namespace

TEST_CASE("a movement has its earlier rest and its motion, without samples whose slopes span the opening or closing") {
    Stream stream;
    CHECK(stream.feed(20, false) == 0);
    CHECK(stream.feed(30, true) == 0);
    CHECK(stream.feed(22, false) == 0);
    CHECK(stream.feed(1, false) == 1);
    REQUIRE(stream.last.at_rest.size() == 17);
    CHECK(stream.last.at_rest.front()[0].inlet_psi == 1001);
    CHECK(stream.last.at_rest.back()[0].inlet_psi == 1017);
    REQUIRE(stream.last.moving.size() == 25); // of 30 samples, the first 3 and the last 2 are left out
    CHECK(stream.last.moving.front()[0].inlet_psi == 1024);
    REQUIRE(stream.last.rest_after.size() == 17); // of 23 samples, the first 3 and the last 3 are left out
    CHECK(stream.last.rest_after.front()[0].inlet_psi == 1054);
    CHECK(stream.last.rest_after.back()[0].inlet_psi == 1070);
    CHECK_FALSE(stream.movement.under_way());
}

TEST_CASE("the next movement ends the rest after the earlier movement") {
    Stream stream;
    stream.feed(30, true);
    CHECK(stream.feed(12, false) == 0);
    CHECK(stream.feed(1, true) == 1);
    CHECK(stream.last.moving.size() == 25);
    CHECK(stream.last.rest_after.size() == 6);
    CHECK(stream.feed(30, true) == 0);
    CHECK(stream.feed(23, false) == 1);
    CHECK(stream.last.at_rest.empty());
    CHECK(stream.last.moving.size() == 25);
}

TEST_CASE("a valve that opens only a little ends the rest after a movement") {
    Stream stream;
    stream.feed(30, true);
    CHECK(stream.feed(12, false) == 0);
    CHECK(stream.feed_inlet(1, Movement::least_inlet_in2 / 2) == 1);
    CHECK(stream.last.moving.size() == 25);
    CHECK(stream.last.rest_after.size() == 6);
}

TEST_CASE("closing the valve for one or two samples does not end a movement") {
    Stream stream;
    stream.feed(10, true);
    CHECK(stream.feed(2, false) == 0);
    CHECK(stream.feed(10, true) == 0);
    CHECK(stream.feed(23, false) == 1);
    CHECK(stream.last.moving.size() == 15);
    CHECK(stream.last.at_rest.empty());
}

TEST_CASE("memory is bounded: only the end of a rest is kept, and long movements are split") {
    Stream stream;
    stream.feed(1000, false);
    CHECK(stream.movement.state().samples.at_rest.size() == 50);
    CHECK(stream.feed(1000, true) == 4);
    CHECK(stream.last.moving.size() == 200);
}

TEST_CASE("durations are in seconds for any sample period") {
    Stream stream;
    stream.movement = Movement({0.01, 1}, {});
    stream.feed(1000, false);
    CHECK(stream.movement.state().samples.at_rest.size() == 100);
    CHECK(stream.feed(1000, true) == 2);
    CHECK(stream.last.moving.size() == 400);
    stream.feed(10, true);
    CHECK(stream.feed(45, false) == 0);
    CHECK(stream.feed(1, false) == 1);
}

TEST_CASE("a movement needs a pump that can exceed the pressure") {
    Stream stream;
    stream.psi = 4600; // above the relief valve
    stream.feed(30, true);
    CHECK_FALSE(stream.movement.under_way());
}
