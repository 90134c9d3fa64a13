// Tests networks that run natively, on threads.

#include "native/native_run.hpp"

#include "classics/kinds.hpp"
#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "runtime/alternation.hpp"
#include "runtime/parallel.hpp"
#include "runtime/recovery.hpp"
#include "runtime/timer.hpp"
#include "tests/native/ring_of.hpp"
#include "tests/sanitized.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <ctime>
#include <set>
#include <stdexcept>
#include <string>

using namespace placedpar;
using namespace placedpar::description;
using namespace std::chrono_literals;

namespace {

using Body = std::function<void(ProcessEnvironment&)>;

/// Returns a kind with the ports `in` and `out` of numbers, which may stay unconnected.
ProcessKind kind_of(const std::string& name, Body body) {
    ProcessKind kind;
    kind.name = name;
    kind.ports = {optional(input<int>("in", "numbers", "numbers")), optional(output<int>("out", "numbers", "numbers"))};
    kind.body = std::move(body);
    return kind;
}

Catalogue kinds_with(const std::vector<ProcessKind>& own) {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    add_classical_kinds(catalogue);
    for (const ProcessKind& kind : own)
        catalogue.add(ProcessKind(kind));
    return catalogue;
}

Network network_of(const std::string& text, const Catalogue& catalogue) {
    ReadResult read = read_netlist_text(text, catalogue, {});
    REQUIRE_MESSAGE(read.network, render(read.diagnostics.front()));
    return *read.network;
}

RunReport run_on(std::size_t threads, const std::string& text, const std::vector<ProcessKind>& own = {}) {
    const Catalogue catalogue = kinds_with(own);
    NativeSettings settings;
    settings.threads = threads;
    settings.make_catalogue = [&] { return std::make_shared<const Catalogue>(kinds_with(own)); };
    return run_natively(network_of(text, catalogue), settings);
}

} // namespace

TEST_CASE("a token goes round a ring, whatever the number of threads") {
    constexpr int rounds = 1000;
    const auto relay =
        kind_of("relay", [](ProcessEnvironment& environment) { test::relay_token(environment, rounds); });
    for (const std::size_t threads : {1U, 2U, 3U, 5U}) {
        const RunReport report = run_on(threads, test::ring_of(5, "relay"), {relay});
        CHECK(report.result.ending == Ending::completed);
        CHECK(report.measured("p[0]", "token") == 5 * rounds);
        CHECK(report.measured("p[4]", "token") == 5 * rounds - 1);
        CHECK(report.processors.size() == threads);
    }
}

TEST_CASE("the messages between threads are counted, with the bytes that links would carry") {
    const auto relay = kind_of("relay", [](ProcessEnvironment& environment) { test::relay_token(environment, 100); });
    const auto sent = [&](std::size_t threads) {
        std::string text;
        for (const MessagesBetween& each : run_on(threads, test::ring_of(5, "relay"), {relay}).messages)
            text += fmt::format("{} > {}: {}, {}; ", each.from, each.to, each.messages, each.bytes);
        return text;
    };
    CHECK(sent(1) == "");
    CHECK(sent(2) == "thread 0 > thread 1: 200, 800; thread 1 > thread 0: 200, 800; ");
    CHECK(sent(5) == "thread 0 > thread 1: 100, 400; thread 1 > thread 2: 100, 400; thread 2 > thread 3: 100, 400; "
                     "thread 3 > thread 4: 100, 400; thread 4 > thread 0: 100, 400; ");
}

TEST_CASE("a deadlock over threads is found at once, and reported as that of a simulated run") {
    const auto sender = kind_of("sender", [](ProcessEnvironment& environment) {
        environment.output<int>("out").output(1);
        environment.input<int>("in").input();
    });
    const Catalogue catalogue = kinds_with({sender});
    const Network network = network_of(test::ring_of(4, "sender"), catalogue);
    const Deadlock simulated = *Machine(network, catalogue, 1).run().result.deadlock;
    for (const std::size_t threads : {1U, 2U, 3U, 4U}) {
        const RunReport report = run_on(threads, test::ring_of(4, "sender"), {sender});
        REQUIRE(report.result.ending == Ending::stuck);
        CHECK(report.result.time < Time(2s));
        REQUIRE(report.result.deadlock);
        CHECK(report.result.deadlock->text() == simulated.text());
    }
}

TEST_CASE("components of PARs on different threads are part of the wait cycle") {
    const auto both = kind_of("both", [](ProcessEnvironment& environment) {
        par([&] { environment.input<int>("in").input(); }, [&] { wait_for(1ms); });
        environment.output<int>("out").output(1);
    });
    const RunReport report = run_on(2, test::ring_of(2, "both"), {both});
    REQUIRE(report.result.deadlock);
    CHECK(std::set(report.result.deadlock->cycle.begin(), report.result.deadlock->cycle.end()) ==
          std::set<std::string>{"p[0]", "p[0]/0", "p[1]", "p[1]/0"});
}

TEST_CASE("what a process throws ends all threads, and names the process, its kind and its place") {
    const auto failing = kind_of("failing", [](ProcessEnvironment& environment) {
        if (environment.process() == "p[2]") {
            wait_for(5ms);
            throw UserError("there is no sand in this box");
        }
        environment.input<int>("in").input();
    });
    try {
        run_on(3, test::ring_of(3, "failing"), {failing});
        FAIL("nothing was thrown");
    } catch (const UserError& refused) {
        const std::string what = refused.what();
        CHECK(what.find("process p[2] (failing) at ") != std::string::npos);
        CHECK(what.find("there is no sand in this box") != std::string::npos);
    }
}

TEST_CASE("an interruption ends processes that compute and processes that wait") {
    const auto busy = kind_of("busy", [](ProcessEnvironment& environment) {
        if (environment.index() == 0)
            for (;;)
                compute(Cycles{1});
        environment.input<int>("in").input();
    });
    const Catalogue catalogue = kinds_with({busy});
    NativeSettings settings;
    settings.threads = 2;
    settings.make_catalogue = [&] { return std::make_shared<const Catalogue>(kinds_with({busy})); };
    settings.is_interrupted = [] { return true; };
    const auto begun = std::chrono::steady_clock::now();
    CHECK(run_natively(network_of(test::ring_of(2, "busy"), catalogue), settings).result.ending == Ending::interrupted);
    CHECK(std::chrono::steady_clock::now() - begun < 1s);
}

TEST_CASE("a process that another thread has woken does not wait for all others of its thread, nor they for it") {
    constexpr int questions = 400;
    static std::atomic<bool> is_asked;
    is_asked = false;
    const auto asker = kind_of("asker", [](ProcessEnvironment& environment) {
        const auto answers = environment.input<int>("in");
        const auto asks = environment.output<int>("out");
        const Time begun = now();
        for (int i = 0; i < questions; ++i) {
            asks.output(i);
            answers.input();
        }
        is_asked = true;
        environment.measure("answer", static_cast<double>((now() - begun).count()) / 1e6 / questions, "us");
    });
    const auto echo = kind_of("echo", [](ProcessEnvironment& environment) {
        for (int i = 0; i < questions; ++i)
            environment.output<int>("out").output(environment.input<int>("in").input());
    });
    const auto crowd = kind_of("crowd", [](ProcessEnvironment& environment) {
        double turns = 0;
        const auto take_turn = [&] {
            const auto until = std::chrono::steady_clock::now() + 50us;
            while (std::chrono::steady_clock::now() < until) {
            }
            ++turns;
        };
        par_for(50, [&](std::size_t) {
            Channel<bool> more("more");
            par(
                [&] {
                    for (; !is_asked; more.out().output(true))
                        take_turn();
                    more.out().output(false);
                },
                [&] {
                    while (more.in().input())
                        take_turn();
                });
        });
        environment.measure("turns", turns);
    });
    const RunReport report = run_on(2, R"(
        T800 t[2]; connect t[0].link[0] to t[1].link[0]; connect t[0].link[1] to t[1].link[1];
        process (interface (input in, output out)) a, e; process crowd;
        use "asker" for a; use "echo" for e; use "crowd" for crowd;
        connect a.out to e.in; connect e.out to a.in;
        place e on t[0]; place crowd on t[0]; place a on t[1];)",
                                    {asker, echo, crowd});
    // In turn with a hundred others, each of the two turns of an answer would come after 5 ms.
    CHECK(report.measured("a", "answer") < 3000);
    CHECK(report.measured("crowd", "turns") >= questions / 2); // the first turns begin the components
}

TEST_CASE("threads that wait use hardly any of the processor") {
    const auto waiting = kind_of("waiting", [](ProcessEnvironment& environment) {
        if (environment.index() == 0) {
            wait_for(500ms);
            return environment.output<int>("out").output(1);
        }
        environment.input<int>("in").input();
    });
    const std::clock_t before = std::clock();
    const RunReport report = run_on(2, test::ring_of(2, "waiting"), {waiting});
    CHECK(report.result.ending == Ending::completed);
    CHECK(report.result.time >= Time(500ms));
    CHECK(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC < (test::sanitized ? 0.2 : 0.05));
}

TEST_CASE("a process waits for the end of the work on all threads") {
    const auto last = kind_of("last", [](ProcessEnvironment& environment) {
        if (environment.index() == 0) {
            wait_until_work_is_over();
            environment.measure("told", environment.input<int>("in").input());
            return;
        }
        wait_for(20ms);
        if (environment.index() == 1)
            wait_until_work_is_over();
        environment.output<int>("out").output(7);
    });
    const RunReport report = run_on(2, test::ring_of(2, "last"), {last});
    CHECK(report.result.ending == Ending::completed);
    CHECK(report.measured("p[0]", "told") == 7);
}

TEST_CASE("a process waits for the end of the work again and again") {
    const auto again = kind_of("again", [](ProcessEnvironment& environment) {
        if (environment.index() == 1) {
            const auto in = environment.input<int>("in");
            int sum = 0;
            for (int i = 0; i < 3; ++i)
                sum += in.input();
            environment.measure("sum", sum);
        } else if (environment.index() == 0) {
            for (int i = 1; i <= 3; ++i) {
                wait_until_work_is_over();
                environment.output<int>("out").output(i);
            }
        }
    });
    for (const std::size_t threads : {1U, 2U, 3U}) {
        const RunReport report = run_on(threads, test::ring_of(3, "again"), {again});
        CHECK(report.result.ending == Ending::completed);
        CHECK(report.measured("p[1]", "sum") == 6);
    }
}

/// Computes for this long.
void work_for(Time how_long) {
    const auto begun = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begun < how_long) {
    }
}

TEST_CASE("the time of a run has its last computation, and no process waits while it computes") {
    const auto slow = kind_of("slow", [](ProcessEnvironment& environment) {
        if (environment.index() == 0)
            return environment.output<int>("out").output(1);
        work_for(60ms);
        environment.input<int>("in").input();
        work_for(60ms);
    });
    for (const std::size_t threads : {1U, 2U}) {
        const RunReport report = run_on(threads, test::ring_of(2, "slow"), {slow});
        CHECK(report.result.time >= Time(120ms));
        CHECK(report.processes[1].waiting < Time(50ms));
        for (const ProcessorUse& thread : report.processors)
            CHECK((thread.busy >= Time{} && thread.busy <= report.result.time));
    }
}

TEST_CASE("an ALT may find that the message on another thread has been given up") {
    const auto hasty = kind_of("hasty", [](ProcessEnvironment& environment) {
        constexpr int tries = 2000;
        if (environment.index() == 0) {
            const auto out = environment.output<int>("out");
            for (int i = 0; i < tries; ++i)
                if (!output_or_fail(out, 1, now() + 1us))
                    reset(out);
            out.output(2);
        } else {
            const auto in = environment.input<int>("in");
            int last = 0, taken = 0;
            while (last != 2)
                alt(on(in, [&](int message) { last = message, ++taken; }), after(now() + 1us, [] {}));
            environment.measure("taken", taken);
        }
    });
    const RunReport report = run_on(2, test::ring_of(2, "hasty"), {hasty});
    CHECK(report.result.ending == Ending::completed);
    CHECK(report.measured("p[1]", "taken") >= 1);
}

TEST_CASE("an output to another thread is given up after a time-out, and may be tried again") {
    const auto trying = kind_of("trying", [](ProcessEnvironment& environment) {
        if (environment.index() == 0) {
            const auto out = environment.output<int>("out");
            int given_up = 0;
            while (!output_or_fail(out, 5, now() + 2ms)) {
                ++given_up;
                reset(out);
            }
            environment.measure("given up", given_up);
        } else if (environment.index() == 1) {
            wait_for(30ms);
            const auto in = environment.input<int>("in");
            environment.measure("got", in.input());
        }
    });
    const RunReport report = run_on(2, test::ring_of(2, "trying"), {trying});
    CHECK(report.result.ending == Ending::completed);
    CHECK(report.measured("p[1]", "got") == 5);
    CHECK(report.measured("p[0]", "given up") >= 1);
}

/// Runs two processes that compute for 400,000 cycles of 20 MHz, 20 ms, each on a processor of its own or on one.
RunReport run_paced(double pace, std::size_t threads, const std::string& where) {
    const auto slow = kind_of("slow", [](ProcessEnvironment& environment) {
        for (int i = 0; i < 4; ++i)
            compute(Cycles{100'000});
        environment.measure("s", std::chrono::duration<double>(now()).count());
    });
    const Catalogue catalogue = kinds_with({slow});
    NativeSettings settings;
    settings.threads = threads;
    settings.pace = pace;
    settings.make_catalogue = [&] { return std::make_shared<const Catalogue>(kinds_with({slow})); };
    return run_natively(network_of(fmt::format("T800 t[2]; connect t[0].link[0] to t[1].link[0]; process p[2];"
                                               "use \"slow\" for p[0]; use \"slow\" for p[1]; {}",
                                               where),
                                   catalogue),
                        settings);
}

TEST_CASE("a paced computation takes its time on the processor, also beside others on the same thread") {
    const std::string apart = "place p[0] on t[0]; place p[1] on t[1];";
    const std::string together = "place p[0] on t[0]; place p[1] on t[0];";
    for (const std::size_t threads : {1U, 2U}) {
        const Time both = run_paced(0.25, threads, apart).result.time;
        CHECK(both >= Time(80ms));
        CHECK(both < Time(140ms)); // 80 ms each at the same time, also on one thread
        CHECK(run_paced(1, threads, apart).result.time >= Time(20ms));
    }
    CHECK(run_paced(0.25, 1, together).result.time >= Time(160ms)); // a processor does one computation at a time
    CHECK(run_paced(0, 1, together).result.time < Time(15ms));
}

TEST_CASE("a message that an ALT on another thread has chosen cannot be given up any more") {
    // The ALT ends after a cycle, 50 us at this pace, and then inputs. Meanwhile the outputter would often give up.
    constexpr int rounds = 300;
    const auto hasty = kind_of("hasty", [](ProcessEnvironment& environment) {
        const auto in = environment.input<int>("in");
        const auto out = environment.output<int>("out");
        int passed = 0;
        for (int i = 0; i < rounds; ++i)
            if (environment.index() == 1) {
                alt(on(in, [&](int) { ++passed; }), after(now() + 200us, [] {}));
                out.output(i);
            } else {
                if (output_or_fail(out, i, now() + std::chrono::microseconds(10 * (i % 20))))
                    ++passed;
                else
                    reset(out);
                CHECK(in.input() == i);
            }
        environment.measure("passed", passed);
    });
    const Catalogue catalogue = kinds_with({hasty});
    NativeSettings settings;
    settings.threads = 2;
    settings.pace = 0.001;
    settings.make_catalogue = [&] { return std::make_shared<const Catalogue>(kinds_with({hasty})); };
    const RunReport report = run_natively(network_of(test::ring_of(2, "hasty"), catalogue), settings);
    REQUIRE(report.result.ending == Ending::completed); // else the ALT's input waits for another message
    CHECK(report.measured("p[0]", "passed") == report.measured("p[1]", "passed"));
}

TEST_CASE("a process communicates while another one of its paced processor computes") {
    const auto both = kind_of("both", [](ProcessEnvironment& environment) {
        if (environment.index() == 1) {
            environment.input<int>("in").input();
            environment.measure("s", std::chrono::duration<double>(now()).count());
        } else {
            par([] { compute(Cycles{4'000'000}); }, [&] { environment.output<int>("out").output(1); }); // 200 ms
        }
    });
    const Catalogue catalogue = kinds_with({both});
    NativeSettings settings;
    settings.pace = 1;
    settings.make_catalogue = [&] { return std::make_shared<const Catalogue>(kinds_with({both})); };
    const RunReport report = run_natively(network_of(test::ring_of(2, "both"), catalogue), settings);
    CHECK(report.result.time >= Time(200ms));
    CHECK(report.measured("p[1]", "s") < 0.1);
}

TEST_CASE("processes on different processors of a paced thread communicate, and a deadlock is found") {
    const auto relay = kind_of("relay", [](ProcessEnvironment& environment) {
        const auto in = environment.input<int>("in");
        const auto out = environment.output<int>("out");
        for (int i = 0; i < 20; ++i) {
            compute(Cycles{1000});
            par([&] { out.output(i); }, [&] { alt(on(in, [](int) {})); });
        }
        if (environment.index() == 0)
            out.output(0);
    });
    const Catalogue catalogue = kinds_with({relay});
    for (const std::size_t threads : {1U, 2U, 3U}) {
        NativeSettings settings;
        settings.threads = threads;
        settings.pace = 10;
        settings.make_catalogue = [&] { return std::make_shared<const Catalogue>(kinds_with({relay})); };
        const RunReport report = run_natively(network_of(test::ring_of(3, "relay"), catalogue), settings);
        CHECK(report.result.ending == Ending::stuck);
        CHECK(report.result.time >= Time(100us));
        REQUIRE(report.result.deadlock);
        CHECK(report.result.deadlock->processes.size() == 1);
    }
}

TEST_CASE("faults are refused") {
    CHECK_THROWS_WITH_AS(run_on(1, test::ring_of(2, "csp.identity") + "fault t[0] halts (from = 1ms);"),
                         doctest::Contains("a native run cannot have faults"), UserError);
}
