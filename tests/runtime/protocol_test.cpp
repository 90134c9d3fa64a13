// Tests the lengths of messages, which follow from the channel's type.

#include "runtime/channel.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/protocol.hpp"
#include "runtime/simulation.hpp"

#include <doctest/doctest.h>

#include <stdexcept>
#include <variant>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;

namespace {

struct Stop {};
struct Sample {
    double pressure, angle;
};
struct FourParts {
    WireForm wire_form() const { return {1, 1, 1, 1}; }
};
/// PROTOCOL Measurements CASE stop; one; SAMPLE; several; INT::[]SAMPLE
using Measurements = std::variant<Stop, Sample, std::vector<Sample>>;

std::uint64_t bytes_on_a_link(const std::vector<Measurements>& messages) {
    Simulation simulation;
    Link& link = simulation.add<Link>();
    Channel<Measurements> channel("measurements", link.from_a_to_b());
    std::size_t stopped = 0;
    simulation.process("sends", [&] {
        for (const Measurements& message : messages)
            channel.out().output(message);
    });
    simulation.process("takes", [&] {
        for (std::size_t i = 0; i < messages.size(); ++i)
            stopped += std::holds_alternative<Stop>(channel.in().input());
    });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(stopped == 1);
    return link.from_a_to_b().bytes_carried();
}

} // namespace

TEST_CASE("a counted array consists of its count and its bytes") {
    WireForm form = wire_form(std::vector<Sample>(3));
    CHECK(form.parts() == 2);
    CHECK(form[0] == 4);
    CHECK(form[1] == 48);
}

TEST_CASE("a variant consists of a tag of one byte and the alternative's own parts") {
    CHECK(wire_form(Measurements(Stop())).total() == 1);
    CHECK(wire_form(Measurements(Stop())).parts() == 1);
    CHECK(wire_form(Measurements(Sample())).total() == 1 + 16);
    CHECK(wire_form(Measurements(Sample())).parts() == 2);
    WireForm several = wire_form(Measurements(std::vector<Sample>(5)));
    CHECK(several.parts() == 3);
    CHECK((several[0] == 1 && several[1] == 4 && several[2] == 80));
    CHECK_THROWS_AS(wire_form(std::variant<int, FourParts>(FourParts())), std::length_error);
}

TEST_CASE("variants of different lengths travel over a link with their own numbers of bytes") {
    CHECK(bytes_on_a_link({Sample(), std::vector<Sample>(2), std::vector<Sample>(0), Stop()}) == 17 + 37 + 5 + 1);
}
