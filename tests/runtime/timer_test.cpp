// Tests TIMERs. A tick is a microsecond at high priority and 64 microseconds at low priority.

#include "runtime/hardware/processor.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

#include <limits>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;
using std::chrono::nanoseconds;

TEST_CASE("a high-priority clock ticks every microsecond, a low-priority clock every 64") {
    for (Priority priority : {Priority::high, Priority::low}) {
        Simulation simulation;
        Processor& t800 = simulation.add<Processor>("t800");
        std::int32_t early = 0, late = 0;
        simulation.process(
            "reader",
            [&] {
                Timer timer;
                wait_until(microseconds{640} - nanoseconds{101}); // a reading takes two cycles, 100 ns
                early = timer.read();
                wait_until(microseconds{640});
                late = timer.read();
            },
            &t800, priority);
        simulation.run();
        CHECK(early == (priority == Priority::high ? 639 : 9));
        CHECK(late == (priority == Priority::high ? 640 : 10));
    }
}

TEST_CASE("AFTER waits until the clock reads more than the given time") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    Time high{}, low{}, past{};
    std::int32_t reading = 0;
    simulation.process(
        "high", [&] { Timer().wait_after(5), high = now(); }, &t800, Priority::high);
    simulation.process(
        "low",
        [&] {
            Timer timer;
            timer.wait_after(3), low = now();
            reading = timer.read();
            timer.wait_after(0), past = now();
        },
        &t800);
    simulation.run();
    CHECK(high == microseconds{6});
    CHECK(low == microseconds{256});
    CHECK(reading == 4);
    CHECK(past == microseconds{256} + nanoseconds{(2 + 4) * 50}); // the process does not wait, but pays the cycles
}

TEST_CASE("the clock has 32 bits, and PLUS, MINUS and AFTER wrap round") {
    constexpr std::int32_t last = std::numeric_limits<std::int32_t>::max(),
                           first = std::numeric_limits<std::int32_t>::min();
    static_assert(plus(last, 1) == first && minus(first, last) == 1);
    static_assert(is_after(first, last) && !is_after(last, first) && !is_after(last, last));
    static_assert(is_after(last, 0) && !is_after(first, 0)); // half a round apart, neither is later

    constexpr Time half_round = (std::int64_t{1} << 31) * microseconds{1};
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    std::int32_t before = 0, behind = 0, round = 0;
    Time waited{};
    bool waited_for_the_past = false;
    simulation.process(
        "reads",
        [&] {
            Timer timer;
            wait_until(half_round - microseconds{10});
            before = timer.read();
            timer.wait_after(plus(before, 20)), waited = now();
            behind = timer.read();
            Time since = now();
            timer.wait_after(before);
            waited_for_the_past = now() - since > microseconds{1};
            wait_until(2 * half_round + microseconds{3});
            round = timer.read();
        },
        &t800, Priority::high);
    simulation.run();
    CHECK(before == last - 9);
    CHECK(waited == half_round + microseconds{11});
    CHECK(behind == first + 11);
    CHECK(!waited_for_the_past);
    CHECK(round == 3);
}

namespace {

constexpr Memory memory_of_t2{.access = Cycles{1}, .bytes_in_a_word = 2};

} // namespace

TEST_CASE("a T2's clock has 16 bits and wraps round where a T8's continues") {
    for (Priority priority : {Priority::high, Priority::low})
        for (bool is_t2 : {true, false}) {
            CAPTURE(is_t2);
            Time tick = priority == Priority::high ? Processor::high_tick : Processor::low_tick;
            Simulation simulation;
            Processor& processor = is_t2 ? simulation.add<Processor>("t2", 20'000'000, Cycles{0}, memory_of_t2)
                                         : simulation.add<Processor>("t8");
            std::int32_t before = 0, behind = 0, lasted = 0, round = 0;
            Time waited{};
            bool later = false, waits_for_the_past = true;
            simulation.process(
                "reads",
                [&] {
                    Timer timer;
                    CHECK(timer.bits() == (is_t2 ? 16 : 32));
                    wait_until(32'758 * tick); // 10 ticks before half a round of a T2's clock
                    before = timer.read();
                    std::int32_t due = timer.plus(before, 20);
                    later = timer.is_after(due, before);
                    timer.wait_after(due), waited = now();
                    behind = timer.read();
                    lasted = timer.minus(behind, before);
                    Time since = now();
                    timer.wait_after(before);
                    waits_for_the_past = now() - since > microseconds{1};
                    wait_until(65'536 * tick + tick / 2);
                    round = timer.read();
                },
                &processor, priority);
            simulation.run();
            CHECK(before == 32'758);
            CHECK(waited == 32'779 * tick);
            CHECK(behind == (is_t2 ? 32'779 - 65'536 : 32'779));
            CHECK(lasted == 21);
            CHECK(later);
            CHECK(!waits_for_the_past);
            CHECK(round == (is_t2 ? 0 : 65'536));
        }
}

TEST_CASE("on a T2 a time more than half a round ahead has passed, and a longer number is reduced to 16 bits") {
    Simulation simulation;
    Processor& t2 = simulation.add<Processor>("t2", 20'000'000, Cycles{0}, memory_of_t2);
    Time passed{}, half{}, longer{};
    simulation.process(
        "waits",
        [&] {
            Timer timer;
            wait_until(microseconds{100});
            timer.wait_after(timer.plus(timer.read(), 32'767 + 2)), passed = now();
            wait_until(microseconds{200});
            timer.wait_after(timer.plus(timer.read(), 32'767)), half = now();
            wait_until(microseconds{65'536});
            timer.wait_after(65'536 + 40), longer = now();
        },
        &t2, Priority::high);
    simulation.run();
    CHECK(passed < microseconds{101});
    CHECK(half == microseconds{200 + 32'768});
    CHECK(longer == microseconds{65'536 + 41});
}

TEST_CASE("delays that end at the same time end in the order in which they began") {
    Simulation simulation;
    std::string order;
    simulation.process("a", [&] { wait_for(nanoseconds{1}), wait_until(nanoseconds{9}), order += "a"; });
    simulation.process("b", [&] { wait_until(nanoseconds{9}), order += "b"; });
    simulation.process("c", [&] { wait_until(nanoseconds{9}), order += "c"; });
    simulation.run();
    CHECK(order == "bca");
}

TEST_CASE("a wait beyond the end of time never returns, and a wait for a past time returns at once") {
    Simulation simulation;
    bool returned = false;
    Time after_past{};
    simulation.process("waits", [&] {
        wait_until(nanoseconds{5});
        wait_until(nanoseconds{3}), after_past = now();
        wait_for(Time::max()), returned = true;
    });
    CHECK(simulation.run(std::chrono::seconds{1}).ending == Ending::time_limit);
    CHECK(after_past == nanoseconds{5});
    CHECK_FALSE(returned);
}

TEST_CASE("times are printed in a unit that suits their size") {
    CHECK(to_string(Time{999}) == "999 ps");
    CHECK(to_string(Time{999'999}) == "999.999 ns");
    CHECK(to_string(microseconds{1}) == "1.000000 us");
    CHECK(to_string(nanoseconds{1'234'567}) == "1.234567 ms");
    CHECK(to_string(std::chrono::seconds{90}) == "90.000000 s");
}

TEST_CASE("a process that waits for no time lets everything else of the same instant happen first") {
    Simulation simulation;
    bool at_once = false, same_moment = false;
    int polls = 0;
    simulation.process("polls", [&] {
        while (!at_once && ++polls < 1000)
            wait_for(Time{0});
        wait_until(nanoseconds{5});
        while (!same_moment && ++polls < 1000)
            wait_until(nanoseconds{3});
        CHECK(now() == nanoseconds{5});
    });
    simulation.process("at once", [&] { at_once = true; });
    simulation.process("at the same moment", [&] { wait_until(nanoseconds{5}), same_moment = true; });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(polls < 10);
}

TEST_CASE("a placed process that waits for no time uses its processor and is timesliced") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    Time stopped{};
    bool flag = false;
    simulation.process(
        "polls",
        [&] {
            while (!flag && now() < std::chrono::seconds{1})
                wait_for(Time{0});
            stopped = now();
        },
        &t800);
    simulation.process(
        "rival", [&] { flag = true; }, &t800);
    simulation.run();
    CHECK(stopped > Time{0});
    CHECK(stopped < 2 * Processor::timeslice);
}

TEST_CASE("a process that polls for ever can be interrupted") {
    for (bool placed : {false, true}) {
        Simulation simulation;
        int polls = 0;
        simulation.process(
            "polls",
            [&] {
                while (++polls < 100'000) {
                    if (polls == 100)
                        simulation.interrupt();
                    wait_for(Time{0});
                }
            },
            placed ? &simulation.add<Processor>("t800") : nullptr);
        CHECK(simulation.run().ending == Ending::interrupted);
        CHECK(polls == 100);
    }
}
