// This program lets 1,000 to 1,000,000 processes wait repeatedly for their timers, each time for a random duration. It
// measures nanoseconds per wait.

#include "bench/measure.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

using namespace placedpar;
using namespace placedpar::bench;

namespace {

void wait_for_timers(std::uint32_t processes, std::size_t events) {
    double before = resident_bytes(), after = 0;
    Stopwatch watch;
    Simulation simulation;
    const std::size_t waits = std::max<std::size_t>(events / processes, 3);
    for (std::uint32_t i = 0; i < processes; ++i)
        simulation.process("", [i, waits] {
            RandomStream random(i, "timers");
            for (std::size_t wait = 0; wait < waits; ++wait)
                wait_for(std::chrono::nanoseconds{1 + random.below(1'000'000)});
        });
    simulation.process("observer", [&] { wait_for(Time{1}), after = resident_bytes(); });
    RunResult result = simulation.run();
    report(fmt::format("{} timers", processes), watch.nanoseconds() / static_cast<double>(processes * waits),
           (after - before) / processes, result.fingerprint);
}

} // namespace

int main(int argc, char** argv) {
    long most = argument(argc, argv, 1, 1'000'000, "timers [MOST PROCESSES, usually 1000000]");
    for (std::uint32_t processes : {1'000u, 30'000u, 200'000u, 1'000'000u})
        if (processes <= most)
            wait_for_timers(processes, static_cast<std::size_t>(3 * most));
}
