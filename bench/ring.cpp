// This program sends a token around a ring of 16 to 1,000,000 processes. It measures nanoseconds per communication and
// the memory of a process. The first round, in which the processes start, is included.

#include "bench/measure.hpp"
#include "runtime/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <deque>

using namespace placedpar;
using namespace placedpar::bench;

namespace {

void pass_token(std::size_t processes, std::size_t events) {
    double before = resident_bytes(), after = 0;
    Stopwatch watch;
    Simulation simulation;
    std::deque<Channel<long>> ring;
    for (std::size_t i = 0; i < processes; ++i)
        ring.emplace_back("");
    const std::size_t rounds = std::max<std::size_t>(events / processes, 2);
    for (std::size_t i = 0; i < processes; ++i)
        simulation.process("", [in = ring[i].in(), out = ring[(i + 1) % processes].out(), i, rounds] {
            if (i == 0)
                out.output(0);
            for (std::size_t round = 1; round < rounds; ++round)
                out.output(in.input() + 1);
            if (i != 0)
                out.output(in.input() + 1);
            else
                in.input();
        });
    // The observer starts after all other processes, and measures the memory while they all live.
    simulation.process("observer", [&] { after = resident_bytes(); });
    RunResult result = simulation.run();
    auto communications = static_cast<double>(processes * rounds);
    report(fmt::format("{} processes", processes), watch.nanoseconds() / communications,
           (after - before) / static_cast<double>(processes), result.fingerprint);
}

} // namespace

int main(int argc, char** argv) {
    const char* usage = "ring [MOST PROCESSES, usually 1000000]";
    auto most = static_cast<std::size_t>(argument(argc, argv, 1, 1'000'000, usage));
    for (std::size_t processes : {16u, 1'000u, 30'000u, 200'000u, 1'000'000u})
        if (processes <= most)
            pass_token(processes, 4 * most);
}
