// Tests occam's rules of alternation.

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;

namespace {

/// Runs `body` in parallel with one process for each channel. Each of these outputs its number at the given time.
std::string run_with_outputs(std::vector<Time> moments,
                             const std::function<void(std::vector<Channel<int>*>, std::string&)>& body) {
    Simulation simulation;
    std::list<Channel<int>> channels;
    std::vector<Channel<int>*> pointers;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        pointers.push_back(&channels.emplace_back(fmt::format("c{}", i)));
        simulation.process(fmt::format("outputter {}", i), [c = pointers.back(), i, at = moments[i]] {
            wait_until(at);
            c->out().output(static_cast<int>(i));
        });
    }
    std::string chosen;
    simulation.process("alternates", [&] { body(pointers, chosen); });
    simulation.run();
    return chosen;
}

} // namespace

TEST_CASE("of several ready guards the first in order is chosen, not the first that became ready") {
    auto chosen = run_with_outputs({microseconds{2}, microseconds{1}}, [](auto c, std::string& log) {
        wait_for(microseconds{3});
        for (int i = 0; i < 2; ++i)
            alt(on(c[0]->in(), [&](int x) { log += fmt::format("{}", x); }),
                on(c[1]->in(), [&](int x) { log += fmt::format("{}", x); }));
    });
    CHECK(chosen == "01");
}

TEST_CASE("if no guard is ready, the first that becomes ready is chosen") {
    auto chosen = run_with_outputs({microseconds{2}, microseconds{1}}, [](auto c, std::string& log) {
        for (int i = 0; i < 2; ++i)
            alt(on(c[0]->in(), [&](int x) { log += fmt::format("{}@{} ", x, now() / microseconds{1}); }),
                on(c[1]->in(), [&](int x) { log += fmt::format("{}@{} ", x, now() / microseconds{1}); }));
    });
    CHECK(chosen == "1@1 0@2 ");
}

TEST_CASE("if both outputters come before the process's turn, it is woken once and chooses by order") {
    Simulation simulation;
    Channel<int> c0("c0"), c1("c1");
    std::string log;
    simulation.process("alternates", [&] {
        for (int i = 0; i < 2; ++i)
            alt(on(c1.in(), [&](int) { log += "1"; }), on(c0.in(), [&](int) { log += "0"; }));
        wait_for(microseconds{1}); // a remaining wake-up would end this wait early
        log += fmt::format("@{}", now() / microseconds{1});
    });
    simulation.process("outputs 0", [&] { c0.out().output(0); });
    simulation.process("outputs 1", [&] { c1.out().output(1); });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(log == "10@1");
}

TEST_CASE("a guard whose condition is false is ignored") {
    auto chosen = run_with_outputs({microseconds{1}, microseconds{2}}, [](auto c, std::string& log) {
        alt(when(false, on(c[0]->in(), [&](int) { log += "wrong"; })),
            on(c[1]->in(), [&](int x) { log += fmt::format("{}", x); }));
        log += fmt::format("{}", c[0]->in().input());
    });
    CHECK(chosen == "10");
}

TEST_CASE("a timeout is chosen at its time if no message comes, and not if a message comes") {
    auto watch = [](auto c, std::string& log) {
        alt(on(c[0]->in(), [&](int) { log += fmt::format("message@{}", now() / microseconds{1}); }),
            after(microseconds{5}, [&] { log += fmt::format("timeout@{}", now() / microseconds{1}); }));
        wait_until(microseconds{20}); // a remaining timer event would end this wait early
        log += now() == microseconds{20} ? "" : " woken early";
    };
    CHECK(run_with_outputs({microseconds{4}}, watch) == "message@4");
    CHECK(run_with_outputs({microseconds{6}}, watch) == "timeout@5");
}

TEST_CASE("a timeout that is already due counts as ready, at its place in the order") {
    auto chosen = run_with_outputs({microseconds{1}}, [](auto c, std::string& log) {
        wait_until(microseconds{3});
        alt(after(microseconds{2}, [&] { log += "t"; }), on(c[0]->in(), [&](int) { log += "m"; }));
        alt(on(c[0]->in(), [&](int) { log += "m"; }), after(microseconds{3}, [&] { log += "t"; }));
    });
    CHECK(chosen == "tm");
}

TEST_CASE("SKIP is chosen only if no guard before it is ready, and a polling process lets others run") {
    int polls = 0;
    auto chosen = run_with_outputs({Time{0}, Time{0}}, [&](auto c, std::string& log) {
        int received = 0;
        while (received < 2) {
            alt(on(c[1]->in(), [&](int x) { log += fmt::format("{}", x), ++received; }),
                on(c[0]->in(), [&](int x) { log += fmt::format("{}", x), ++received; }), skip([] {}));
            ++polls;
        }
    });
    CHECK(chosen == "10");
    CHECK(polls >= 2);

    Simulation simulation; // the poller runs first; if it did not yield, no other process could run
    Channel<int> c("c");
    bool got = false;
    simulation.process("polls", [&] {
        while (!got)
            alt(on(c.in(), [&](int) { got = true; }), skip([] {}));
    });
    simulation.process("outputs", [&] { c.out().output(1); });
    CHECK(simulation.run().ending == Ending::completed);
}

TEST_CASE("a replicated alternation gives the number of the chosen input") {
    auto chosen = run_with_outputs({microseconds{3}, microseconds{1}, microseconds{2}}, [](auto c, std::string& log) {
        std::vector<Input<int>> inputs;
        for (auto* channel : c)
            inputs.push_back(channel->in());
        for (int i = 0; i < 3; ++i)
            alt(std::span<const Input<int>>(inputs), [&](std::size_t k, int x) { log += fmt::format("{}{} ", k, x); });
    });
    CHECK(chosen == "11 22 00 ");
}

namespace {

/// Returns the order in which messages of three outputters are taken, as digits. Each outputter sends five.
template <class Take>
std::string taken(int messages, const Take& take) {
    Simulation simulation;
    std::list<Channel<int>> channels;
    std::vector<Input<int>> inputs;
    for (int i = 0; i < 3; ++i) {
        auto& channel = channels.emplace_back(fmt::format("c{}", i));
        inputs.push_back(channel.in());
        simulation.process(fmt::format("outputter {}", i), [&channel, i] {
            for (int n = 0; n < 5; ++n)
                channel.out().output(i);
        });
    }
    std::string log;
    simulation.process("alternates", [&] {
        for (int n = 0; n < messages; ++n) {
            wait_for(microseconds{1}); // all outputters become ready again
            take(std::span<const Input<int>>(inputs), log);
        }
    });
    simulation.run();
    return log;
}

void note(std::string& log, int x) { log += static_cast<char>('0' + x); }

} // namespace

TEST_CASE("a replicated guard may be followed by a time-out, at its place in the order") {
    std::string chosen = run_with_outputs({microseconds{5}, microseconds{1}}, [](auto c, std::string& log) {
        std::vector<Input<int>> inputs{c[0]->in(), c[1]->in()};
        for (int i = 0; i < 3; ++i) {
            std::size_t index = alt(each(std::span<const Input<int>>(inputs),
                                         [&](std::size_t from, int x) { log += fmt::format("{}={}", from, x); }),
                                    after(microseconds{3}, [&] { log += "late"; }));
            log += fmt::format("@{}#{} ", now() / microseconds{1}, index);
            if (index == 2)
                wait_until(microseconds{6});
        }
    });
    CHECK(chosen == "1=1@1#1 late@3#2 0=0@6#0 ");
}

TEST_CASE("PRI ALT chooses the first input as long as it is ready, and a fair ALT chooses each in turn") {
    CHECK(taken(9, [](auto inputs, std::string& log) {
              alt(each(inputs, [&](std::size_t, int x) { note(log, x); }));
          }) == "000001111");
    Turn turn;
    CHECK(taken(15, [&](auto inputs, std::string& log) {
              alt(each(inputs, turn, [&](std::size_t i, int x) { note(log, static_cast<int>(i) == x ? x : 9); }));
          }) == "012012012012012");
}

TEST_CASE("a replicated guard, also a fair one, may have a condition that depends on the number of the input") {
    Turn turn;
    CHECK(taken(6, [&](auto inputs, std::string& log) {
              alt(when([](std::size_t i) { return i != 1; },
                       each(inputs, turn, [&](std::size_t, int x) { note(log, x); })));
          }) == "020202");
    CHECK(taken(2, [&](auto inputs, std::string& log) {
              alt(when(false, each(inputs, [&](std::size_t, int x) { note(log, x); })), skip([&] { log += "skip "; }));
          }) == "skip skip ");
}

TEST_CASE("an ALT within an ALT keeps its place, and a condition before it applies to all its guards") {
    for (bool condition : {true, false})
        CHECK(taken(3, [&](auto inputs, std::string& log) {
                  auto from = [&](std::size_t i) { return on(inputs[i], [&](int x) { note(log, x); }); };
                  alt(when(condition, either(from(2), from(1))), from(0));
              }) == (condition ? "222" : "000"));
}

TEST_CASE("a replicated guard without inputs is never ready") {
    CHECK(taken(1, [](auto, std::string& log) {
              alt(each(std::span<const Input<int>>(), [](std::size_t, int) {}), skip([&] { log += "skip"; }));
          }) == "skip");
}

TEST_CASE("an alternation whose guards can never become ready is an error that names the process") {
    Simulation simulation;
    Channel<int> c("c");
    simulation.process("hopeless", [&] { alt(when(false, on(c.in(), [](int) {}))); });
    CHECK_THROWS_WITH_AS(simulation.run(), "process hopeless: no guard of its alternation can ever become ready",
                         std::logic_error);
}

TEST_CASE("two processes cannot alternate on one channel, and one cannot input where another alternates") {
    for (bool second_alternates : {false, true}) {
        Simulation simulation;
        Channel<int> c("c");
        simulation.process("first", [&] { alt(on(c.in(), [](int) {})); });
        simulation.process("second", [&] {
            if (second_alternates)
                alt(on(c.in(), [](int) {}));
            else
                c.in().input();
        });
        CHECK_THROWS_AS(simulation.run(), std::logic_error);
    }
}

TEST_CASE("a channel can be in two guards of an alternation") {
    auto chosen = run_with_outputs({microseconds{1}}, [](auto c, std::string& log) {
        alt(when(false, on(c[0]->in(), [&](int) { log += "wrong"; })), on(c[0]->in(), [&](int) { log += "a"; }),
            on(c[0]->in(), [&](int) { log += "b"; }));
    });
    CHECK(chosen == "a");
}

TEST_CASE("over a link the first byte of a message wakes an alternation") {
    Simulation simulation;
    Channel<std::array<char, 100>> c("c");
    Channel<int> local("local");
    c.put_on(simulation.add<Link>().from_a_to_b());
    simulation.process("sender", [&] { c.out().output({}); });
    Time woken{}, received{};
    simulation.process("receiver", [&] {
        std::vector<Guard> guards{{Guard::input, &local}, {Guard::input, &c}};
        CHECK(select(guards) == 1);
        woken = now();
        c.in().input();
        received = now();
    });
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(woken == std::chrono::nanoseconds{550});
    // The acknowledge is sent at 550 ns instead of 260 ns. The next byte follows after 6 bits, then one every 560 ns.
    CHECK(received == std::chrono::nanoseconds{550 + 300 + 98 * 560 + 550});
}

TEST_CASE("a timeout that is already due does not stop other processes, nor hide an interruption") {
    Simulation simulation;
    Channel<int> c("c");
    bool got = false;
    int polls = 0;
    simulation.process("polls", [&] {
        while (!got && ++polls < 100'000)
            alt(on(c.in(), [&](int) { got = true; }), after(now(), [] {}));
        while (++polls < 100'000) {
            simulation.interrupt();
            alt(on(c.in(), [&](int) {}), after(Time{0}, [] {}));
        }
    });
    simulation.process("outputs", [&] { c.out().output(1); });
    CHECK(simulation.run().ending == Ending::interrupted);
    CHECK(got);
    CHECK(polls < 10);
}

TEST_CASE("time passes while a placed process polls, so timeouts and messages come") {
    Simulation simulation;
    Channel<int> c("c");
    Time got{}, timed_out{};
    simulation.process(
        "polls",
        [&] {
            for (int polls = 0; polls < 100'000 && timed_out == Time{0}; ++polls)
                alt(on(c.in(), [&](int) { got = now(); }), after(microseconds{300}, [&] { timed_out = now(); }),
                    skip([] {}));
        },
        &simulation.add<Processor>("t800"));
    simulation.process("outputs", [&] { wait_until(microseconds{100}), c.out().output(1); });
    CHECK(simulation.run().ending == Ending::completed);
    constexpr microseconds longest_poll{10};
    CHECK(got >= microseconds{100});
    CHECK(got < microseconds{100} + longest_poll);
    CHECK(timed_out >= microseconds{300});
    CHECK(timed_out < microseconds{300} + longest_poll);
}

TEST_CASE("enabling is paid before the wait and disabling after it, so a wake costs more with more guards") {
    // If the message arrives at 1 ms, these instructions remain: disc of each guard, altend, in, and the copy of one
    // word. If the message is waiting already, enbc of its guard takes two cycles more than enbc of the others.
    for (std::int64_t guards : {1, 10})
        for (bool message_first : {false, true}) {
            CAPTURE(guards);
            CAPTURE(message_first);
            Simulation simulation;
            std::list<Channel<int>> channels;
            std::vector<Input<int>> inputs;
            for (std::int64_t i = 0; i < guards; ++i)
                inputs.push_back(channels.emplace_back("c").in());
            constexpr microseconds late{1000};
            Time received{};
            simulation.process(
                "alternates",
                [&] {
                    if (message_first)
                        wait_until(late);
                    alt(std::span<const Input<int>>(inputs), [&](std::size_t, int) { received = now(); });
                },
                &simulation.add<Processor>("t800"));
            simulation.process("outputs", [&] {
                if (!message_first)
                    wait_until(late);
                channels.front().out().output(1);
            });
            simulation.run();
            std::int64_t enabling = 2 + 7 + 5 * (guards - 1) + 5, disabling = 8 * guards + 4, input = 19 + 2;
            std::int64_t cycles = (message_first ? enabling : 0) + disabling + input;
            CHECK(received == late + cycles * std::chrono::nanoseconds{50});
        }
}

TEST_CASE("a timeout costs the cycles of its instructions") {
    Simulation simulation;
    Time taken{};
    simulation.process(
        "waits", [&] { alt(after(microseconds{50}, [&] { taken = now(); })); }, &simulation.add<Processor>("t800"));
    simulation.run();
    CHECK(taken == microseconds{50} + (23 + 4) * std::chrono::nanoseconds{50});
}
