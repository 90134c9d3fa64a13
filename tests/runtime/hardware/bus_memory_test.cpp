#include "runtime/hardware/bus_memory.hpp"

#include "runtime/channel.hpp"
#include "runtime/hardware/bus_programs.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/workstation.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::nanoseconds;

namespace {

struct Words {
    std::int32_t words[100];
};

/// A Sun and a BBK-V2 on one bus.
struct Machine {
    Simulation simulation;
    VmeBus& bus = simulation.add<VmeBus>("bus");
    Workstation& sun = simulation.add<Workstation>("sun");
    VmeMaster& host = simulation.add<VmeMaster>("sun", bus, VmePlace{}, bus_programs::sun_3_280);
    Processor& bbk = simulation.add<Processor>("bbk", 20'000'000, Cycles{0}, Memory{.access = Cycles{3}});
    VmeMaster& master = simulation.add<VmeMaster>("bbk", bus, VmePlace{.slot = 2}, bus_programs::bbk_v2);
    DualPortedMemory& memory = simulation.add<DualPortedMemory>("bbk.memory");
};

constexpr Time bus_cycle = nanoseconds{200} + nanoseconds{310};

} // namespace

TEST_CASE("a host writes a message into a bus master's memory word by word") {
    Machine machine;
    auto& lane = machine.simulation.add<MemoryLane>(machine.host, machine.memory, MemoryLane::From::master,
                                                    bus_programs::conversion);
    Channel<Words> c("c", lane);
    Time sent{}, received{};
    std::int32_t last = 0;
    machine.simulation.process(
        "host",
        [&] {
            Words words{};
            words.words[99] = 42;
            c.out().output(words);
            sent = now();
        },
        &machine.sun);
    machine.simulation.process(
        "node",
        [&] {
            last = c.in().input().words[99];
            received = now();
        },
        &machine.bbk);
    CHECK(machine.simulation.run().ending == Ending::completed);
    CHECK(last == 42);
    Time written = 100 * (duration_of(26, 25'000'000) + bus_cycle);
    Time copied = duration_of(100 * (2 * 3 + 4), 20'000'000);
    CHECK(received == written + copied);
    CHECK(sent == received + duration_of(2500, 25'000'000)); // its interrupt costs 2500 cycles
    CHECK(machine.host.words_moved() == 100);
}

TEST_CASE("a host reads a message from a bus master's memory") {
    Machine machine;
    auto& lane = machine.simulation.add<MemoryLane>(machine.host, machine.memory, MemoryLane::From::memory,
                                                    bus_programs::conversion);
    Channel<Words> c("c", lane);
    Time received{};
    machine.simulation.process(
        "host", [&] { c.in().input(), received = now(); }, &machine.sun);
    machine.simulation.process(
        "node", [&] { c.out().output({}); }, &machine.bbk);
    CHECK(machine.simulation.run().ending == Ending::completed);
    Time copied = duration_of(19 + 100 * (2 * 3 + 4), 20'000'000), interrupt = duration_of(2500, 25'000'000);
    Time read = 100 * (duration_of(92, 25'000'000) + bus_cycle), told = duration_of(26, 25'000'000) + bus_cycle;
    CHECK(received == copied + interrupt + read + told);
}

TEST_CASE("a bus master moves a message into another's memory as one block, or in parts if it is long") {
    Machine machine;
    auto& other = machine.simulation.add<Processor>("other");
    auto& memory = machine.simulation.add<DualPortedMemory>("other.memory");
    auto& lane = machine.simulation.add<MemoryLane>(machine.master, memory, MemoryLane::From::master, Cycles{0});
    Channel<std::vector<std::int32_t>> c("c", lane);
    std::vector<std::int32_t> sent(20'000, 3), received;
    machine.simulation.process(
        "a", [&] { c.out().output(sent); }, &machine.bbk);
    machine.simulation.process(
        "b", [&] { received = c.in().input(); }, &other);
    CHECK(machine.simulation.run().ending == Ending::completed);
    CHECK(received == sent);
    CHECK(machine.master.words_moved() == 20'001);
    CHECK(machine.master.grants() == 2); // of at most 65536 bytes each
}
