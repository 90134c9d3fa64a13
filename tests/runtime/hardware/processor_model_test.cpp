// Tests random loads on a processor against a model that is clocked cycle by cycle.

#include "processor_model.hpp"

#include "runtime/hardware/processor.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/cycle.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace placedpar::test;

namespace {

std::vector<Load> random_loads(RandomStream& random) {
    std::vector<Load> loads(1 + random.below(6));
    for (Load& load : loads) {
        load.high = random.chance(0.3);
        load.steps.resize(1 + random.below(6));
        for (auto& step : load.steps)
            step = {random.chance(0.2) ? 0 : 1 + random.below(30'000), 1 + random.below(load.high ? 3'000 : 60'000),
                    random.chance(0.5) ? 1 : 1 + random.below(5'000)};
        load.steps[0].rest = 1 + random.below(30'000); // otherwise the order of creation would matter
    }
    return loads;
}

std::int64_t sum_of_computations(const std::vector<Load>& loads) {
    std::int64_t sum = 0;
    for (const Load& load : loads)
        for (const auto& step : load.steps)
            sum += step.compute;
    return sum;
}

} // namespace

TEST_CASE("random loads take the cycles of a clocked processor, each and in sum") {
    for (std::uint64_t seed : test::seeds(60)) {
        INFO(test::replay(seed));
        RandomStream random(seed, "processor");
        auto loads = random_loads(random);
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800");
        std::vector<std::vector<std::int64_t>> ended(loads.size());
        for (std::size_t p = 0; p < loads.size(); ++p)
            simulation.process(
                fmt::format("process {}", p),
                [&, p] {
                    for (const auto& step : loads[p].steps) {
                        if (step.rest > 0)
                            wait_for(step.rest * cycle);
                        compute(Cycles{step.compute}, {.between_points = Cycles{step.between_points}});
                        ended[p].push_back(now() / cycle);
                    }
                },
                &t800, loads[p].high ? Priority::high : Priority::low);
        REQUIRE(simulation.run().ending == Ending::completed);
        ProcessorModel model(loads);
        REQUIRE(ended == model.run());
        REQUIRE(t800.time_busy() == model.busy() * cycle);
        // No time is lost: besides the requested computations there are only whole interrupts.
        REQUIRE((model.busy() - sum_of_computations(loads)) % ProcessorModel::interrupt == 0);
    }
}
