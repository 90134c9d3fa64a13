#include "runtime/hardware/vme_bus.hpp"

#include "bus_model.hpp"
#include "runtime/hardware/bus_memory.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>

#include <array>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using placedpar::test::BusWorld;
using std::chrono::microseconds;
using std::chrono::nanoseconds;

namespace {

struct Memory64K final : BusSlave {
    std::string name = "memory";
    const std::string& bus_name() const override { return name; }
};

Arbitration arbitration_of(BusWorld::Rule rule) {
    return rule == BusWorld::Rule::priority      ? Arbitration::priority
           : rule == BusWorld::Rule::round_robin ? Arbitration::round_robin
                                                 : Arbitration::single_level;
}

constexpr Time unit = nanoseconds{1};

/// Returns the same times as ends_of_blocks(), but from the runtime's bus.
std::vector<std::vector<int>> run(const BusWorld& world) {
    Simulation simulation;
    VmeTiming timing{.word = world.word * unit, .arbitration = world.arbitration * unit};
    auto& bus = simulation.add<VmeBus>("bus", arbitration_of(world.rule), timing);
    Memory64K memory;
    std::vector<std::vector<int>> ends(world.masters.size());
    for (std::size_t i = 0; i < world.masters.size(); ++i) {
        const auto& master = world.masters[i];
        VmePlace place{master.level, master.slot, master.on_request ? Release::on_request : Release::when_done};
        auto& on_bus = simulation.add<VmeMaster>("m" + std::to_string(i), bus, place);
        simulation.process("p" + std::to_string(i), [&, i] {
            for (const auto& block : world.masters[i].blocks) {
                if (block.pause > 0)
                    wait_for(block.pause * unit);
                on_bus.move_words(memory, static_cast<std::uint64_t>(block.words));
                ends[i].push_back(static_cast<int>(now() / unit));
            }
        });
    }
    CHECK(simulation.run().ending == Ending::completed);
    return ends;
}

/// Returns a master's program for each number: the time of the first request, its length, and the time of the second
/// request.
std::vector<BusWorld::Block> program(int number) {
    return {{number & 1 ? 5 : 0, number & 2 ? 3 : 1}, {number & 4 ? 7 : 0, 2}};
}

constexpr int programs = 6;

BusWorld world_of(BusWorld::Rule rule, const std::array<int, 3>& levels, int releases, int chosen) {
    BusWorld world{rule, 10, 4, {}};
    for (int m = 0; m < 3; ++m, chosen /= programs)
        world.masters.push_back(
            {levels[static_cast<std::size_t>(m)], 3 - m, ((releases >> m) & 1) != 0, program(chosen % programs)});
    return world;
}

} // namespace

TEST_CASE("every small world of three masters has the times of a model that moves words one by one") {
    using Rule = BusWorld::Rule;
    const std::vector<std::array<int, 3>> levels{{3, 3, 3}, {3, 2, 2}, {0, 1, 3}, {2, 2, 3}};
    test::EveryNth some(20);
    for (Rule rule : {Rule::priority, Rule::round_robin, Rule::single_level})
        for (const auto& of_masters : levels) {
            if (rule == Rule::single_level && of_masters != levels.front())
                continue;
            for (int releases = 0; releases < 8; ++releases)
                for (int chosen = 0; chosen < programs * programs * programs; ++chosen) {
                    if (some.passes_over())
                        continue;
                    BusWorld world = world_of(rule, of_masters, releases, chosen);
                    if (run(world) != ends_of_blocks(world))
                        FAIL(world.text());
                }
        }
}

TEST_CASE("a block of words takes one arbitration, and a word's time for each word") {
    Simulation simulation;
    auto& bus = simulation.add<VmeBus>("bus");
    auto& master = simulation.add<VmeMaster>("master", bus);
    Memory64K memory;
    simulation.process("mover", [&] { master.move_words(memory, 1000); });
    CHECK(simulation.run().time == nanoseconds{200} + 1000 * nanoseconds{310});
    CHECK(bus.time_busy() == 1000 * nanoseconds{310}); // 12.9 Mbyte/s
    CHECK(master.words_moved() == 1000);
    CHECK(master.grants() == 1);
    CHECK(master.time_waited() == nanoseconds{200});
}

TEST_CASE("a bus that is kept until another master requests it needs no arbitration") {
    for (auto [release, grants] : {std::pair(Release::when_done, 10), std::pair(Release::on_request, 1)}) {
        Simulation simulation;
        auto& bus = simulation.add<VmeBus>("bus");
        auto& master = simulation.add<VmeMaster>("master", bus, VmePlace{.release = release});
        Memory64K memory;
        simulation.process("mover", [&] {
            for (int i = 0; i < 10; ++i)
                master.move_words(memory, 1);
        });
        CHECK(simulation.run().time == grants * nanoseconds{200} + 10 * nanoseconds{310});
        CHECK(master.grants() == static_cast<std::uint64_t>(grants));
    }
}

TEST_CASE("if no slave responds, the bus timer ends the cycle and the program gets an error") {
    Simulation simulation;
    auto& bus = simulation.add<VmeBus>("bus");
    auto& master = simulation.add<VmeMaster>("master", bus);
    Memory64K memory;
    const BusSlave::Absence& now = memory.leave(Time{0}, microseconds{1});
    const BusSlave::Absence& later = memory.leave(microseconds{200}, Time::max());
    std::string told;
    simulation.process("mover", [&] {
        try {
            master.move_words(memory, 5);
        } catch (const BusError& error) {
            told = error.what();
        }
    });
    CHECK(simulation.run().time == nanoseconds{200} + microseconds{125});
    CHECK(told == "bus error: memory does not answer master on bus bus within 125.000000 us");
    CHECK(master.bus_errors() == 1);
    CHECK(now.unanswered == 1);
    CHECK(later.unanswered == 0);
    CHECK(master.words_moved() == 0);
}

TEST_CASE("a bus that is held keeps all other masters waiting until it is released") {
    Simulation simulation;
    auto& bus = simulation.add<VmeBus>("bus");
    auto& hog = simulation.add<VmeMaster>("hog", bus, VmePlace{.level = 0, .slot = 2});
    auto& master = simulation.add<VmeMaster>("master", bus);
    Memory64K memory;
    simulation.process("hog", [&] { hog.hold(std::chrono::milliseconds{1}); });
    simulation.process("mover", [&] {
        wait_for(microseconds{1});
        master.move_words(memory, 1);
    });
    CHECK(simulation.run().time == 2 * nanoseconds{200} + std::chrono::milliseconds{1} + nanoseconds{310});
    CHECK(master.longest_wait() == std::chrono::milliseconds{1} + 2 * nanoseconds{200} - microseconds{1});
}

TEST_CASE("a process that waits for the bus keeps its processor, which then continues with others") {
    Simulation simulation;
    auto& bus = simulation.add<VmeBus>("bus");
    auto& t800 = simulation.add<Processor>("t800");
    auto& master = simulation.add<VmeMaster>("t800", bus);
    Memory64K memory;
    Time moved{}, computed{};
    simulation.process(
        "mover", [&] { master.move_words(memory, 100), moved = now(); }, &t800);
    simulation.process(
        "worker", [&] { compute(Cycles{20}), computed = now(); }, &t800, Priority::high);
    simulation.run();
    CHECK(moved == nanoseconds{200} + 100 * nanoseconds{310});
    CHECK(computed == moved + microseconds{1});
}

TEST_CASE("a level or slot that a bus does not have, or that is taken, is refused") {
    Simulation simulation;
    auto& bus = simulation.add<VmeBus>("bus", Arbitration::single_level);
    simulation.add<VmeMaster>("first", bus);
    CHECK_THROWS_WITH(simulation.add<VmeMaster>("second", bus), "bus bus: first and second are both masters in slot 1");
    CHECK_THROWS_WITH(simulation.add<VmeMaster>("third", bus, VmePlace{.level = 2, .slot = 2}),
                      "bus bus: on a bus with a single level every master must have BR3; third has BR2");
    CHECK_THROWS_WITH(
        simulation.add<VmeMaster>("fourth", bus, VmePlace{.level = 3, .slot = 22}),
        "bus bus: a master has a level from 0 to 3 and a slot from 1 to 21; fourth has level 3 and slot 22");
    CHECK_THROWS_AS(simulation.add<VmeBus>("idle", Arbitration::priority, VmeTiming{.word = Time{0}}),
                    std::logic_error);
}
