#include "hydraulics/data/record_table.hpp"
#include "hydraulics/plant/excavator_record.hpp"
#include "hydraulics/plant/excavator_values.hpp"
#include "hydraulics/plant/measurement.hpp"
#include "runtime/random.hpp"

#include <doctest/doctest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hydraulics;

namespace {

Record example(const char* name) {
    std::ifstream in(std::string(PLACEDPAR_SOURCE_DIR "/examples/hydraulics/monitor/") + name);
    ReadRecord read = read_record(std::string(std::istreambuf_iterator<char>(in), {}));
    REQUIRE(read.record);
    return *read.record;
}

/// Returns the record of scenario A at low noise.
Record measured() {
    ExcavatorScenario scenario = single_boom_scenario();
    RandomStream random(1, "noise");
    return measure_excavator(simulate_excavator(scenario), scenario, 0.020, low_noise,
                             [&] { return random.uniform(); });
}

void check_equal(const Record& file, const Record& simulated) {
    REQUIRE(file.size() == simulated.size());
    // The tolerance is half a step of the last digit in the file.
    for (auto [sensor, rounding] :
         {std::pair{Sensor::inlet_pressure, 0.0501}, {Sensor::angle, 0.0000501}, {Sensor::spool, 0.00000501}})
        for (std::size_t i = 0; i < file.size(); ++i)
            CHECK(std::abs(file.of(Link::boom, sensor)[i] - simulated.of(Link::boom, sensor)[i]) <= rounding);
}

} // namespace

TEST_CASE("the example's record agrees with its description") { check_equal(example("boom.csv"), measured()); }
