// Tests native runs on ranks, which are threads of the test here. tests/app/native_ranks_test.py tests mpirun.

#include "tests/native/made_up_ranks.hpp"
#include "tests/native/ring_of.hpp"
#include "tests/native/told_trace.hpp"

#include "netlist/machine.hpp"
#include "runtime/alternation.hpp"
#include "runtime/parallel.hpp"
#include "runtime/recovery.hpp"
#include "runtime/timer.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <string>

using namespace placedpar;
using namespace placedpar::test;
using namespace std::chrono_literals;

TEST_CASE("a token goes round a ring, whatever the number of ranks") {
    constexpr int rounds = 300;
    const auto relay = rank_kind("relay", [](ProcessEnvironment& environment) { relay_token(environment, rounds); });
    for (const int ranks : {1, 2, 3, 5}) {
        const OnRanks run = on_ranks(ranks, ring_of(5, "relay"), {relay}, {.sends_notes = true});
        REQUIRE_MESSAGE(run.report, what_was_thrown(run));
        CHECK(run.report->result.ending == Ending::completed);
        CHECK(run.report->measured("p[0]", "token") == 5 * rounds);
        CHECK(run.report->measured("p[4]", "token") == 5 * rounds - 1);
        CHECK(run.report->processors.size() == static_cast<std::size_t>(ranks));
        CHECK(run.report->processors.back().name == fmt::format("rank {}", ranks - 1));
        for (const MessagesBetween& each : run.report->messages)
            CHECK(each.bytes == 4 * each.messages);
        const auto& sent = run.report->messages;
        CHECK(std::accumulate(sent.begin(), sent.end(), std::uint64_t{0},
                              [](std::uint64_t sum, const auto& each) { return sum + each.messages; }) ==
              (ranks == 1   ? 0
               : ranks == 2 ? 4
                            : 5) *
                  rounds);
        CHECK(run.notes.size() == 2 * static_cast<std::size_t>(ranks - 1));
        for (std::size_t i = 0; i < run.notes.size(); ++i) // those of one rank are in order
            CHECK(std::ranges::count_if(run.notes.begin(), run.notes.begin() + static_cast<std::ptrdiff_t>(i),
                                        [&](const std::string& each) { return each[0] == run.notes[i][0]; }) ==
                  run.notes[i][1]);
    }
}

TEST_CASE("a deadlock over ranks is reported as that of a simulated run") {
    const auto sender = rank_kind("sender", [](ProcessEnvironment& environment) {
        environment.output<int>("out").output(1);
        environment.input<int>("in").input();
    });
    const Catalogue catalogue = rank_kinds({sender});
    const Network network = *read_netlist_text(ring_of(4, "sender"), catalogue, {}).network;
    const Deadlock simulated = *Machine(network, catalogue, 1).run().result.deadlock;
    for (const int ranks : {1, 2, 3, 4}) {
        const OnRanks run = on_ranks(ranks, ring_of(4, "sender"), {sender});
        REQUIRE(run.report);
        REQUIRE(run.report->result.ending == Ending::stuck);
        REQUIRE(run.report->result.deadlock);
        CHECK(run.report->result.deadlock->text() == simulated.text());
    }
}

TEST_CASE("a deadlock over ranks names partners that have ended, and components of PARs") {
    const auto both = rank_kind("both", [](ProcessEnvironment& environment) {
        par([&] { environment.input<int>("in").input(); }, [&] { wait_for(1ms); });
        environment.output<int>("out").output(1);
    });
    const OnRanks run = on_ranks(2, ring_of(2, "both"), {both});
    REQUIRE(run.report);
    REQUIRE(run.report->result.deadlock);
    CHECK(run.report->result.deadlock->cycle == std::vector<std::string>{"p[0]", "p[0]/0", "p[1]", "p[1]/0"});

    const auto early = rank_kind("early", [](ProcessEnvironment& environment) {
        if (environment.index() == 0)
            environment.input<int>("in").input();
    });
    const OnRanks ended = on_ranks(2, ring_of(2, "early"), {early});
    REQUIRE(ended.report->result.deadlock);
    CHECK(ended.report->result.deadlock->text().starts_with("no wait cycle: p[0] inputs for ever, but p[1] has ended"));
}

TEST_CASE("the trace of ranks has the messages of the simulated run, by one clock") {
    for (const std::size_t length : {1u, 5000u}) {
        const auto relay = rank_kind<std::vector<int>>("relay", [length](ProcessEnvironment& environment) {
            for (int i = 0; i < 50; ++i) {
                if (environment.index() > 0)
                    environment.input<std::vector<int>>("in").input();
                environment.output<std::vector<int>>("out").output(std::vector<int>(length, i));
                if (environment.index() == 0)
                    environment.input<std::vector<int>>("in").input();
            }
        });
        const Catalogue kinds = rank_kinds({relay});
        const Network network = *read_netlist_text(test::ring_of(5, "relay"), kinds, {}).network;
        test::SimulatedMessages simulated;
        Machine machine(network, kinds, 1);
        machine.trace_to(simulated);
        machine.run();
        for (const int ranks : {2, 3, 5}) {
            NativeTrace trace;
            const OnRanks run = on_ranks(ranks, test::ring_of(5, "relay"), {relay}, {.trace = &trace});
            REQUIRE_MESSAGE(run.report, what_was_thrown(run));
            REQUIRE(run.report->clocks.size() == static_cast<std::size_t>(ranks - 1));
            Time error{};
            for (const RankClock& clock : run.report->clocks) {
                CHECK(Time(std::chrono::abs(clock.ahead)) <= clock.error); // these ranks have one clock
                CHECK(clock.error > Time{});
                error = std::max(error, clock.error);
            }
            test::ToldTrace told;
            trace.replay(network, told);
            CHECK(told.passed() == simulated.passed);
            told.check_causes(times(2, error)); // both ranks may be off
            CHECK(told.is_computing.size() == static_cast<std::size_t>(ranks));
            CHECK(told.end == run.report->result.time);
        }
    }
    CHECK(on_ranks(2, test::ring_of(2, "csp.identity"), {}).report->clocks.empty());
}

TEST_CASE("long messages are sent as parcels, and short ones are not") {
    const auto sends = [](std::size_t length) {
        return rank_kind<std::vector<double>>("sends", [length](ProcessEnvironment& environment) {
            if (environment.index() == 0) {
                std::vector<double> values(length);
                std::iota(values.begin(), values.end(), 1);
                for (int i = 0; i < 3; ++i)
                    environment.output<std::vector<double>>("out").output(values);
            } else {
                double sum = 0;
                for (int i = 0; i < 3; ++i) {
                    const auto values = environment.input<std::vector<double>>("in").input();
                    sum += std::accumulate(values.begin(), values.end(), 0.0);
                }
                environment.measure("sum", sum);
            }
        });
    };
    for (const std::size_t length : {0u, 1u, 400u, 500u, 5000u, 300000u}) {
        const OnRanks run = on_ranks(2, ring_of(2, "sends"), {sends(length)});
        REQUIRE(run.report);
        const auto n = static_cast<double>(length);
        CHECK(run.report->measured("p[1]", "sum") == 3 * n * (n + 1) / 2);
        CHECK(run.parcels == 1 + (length >= 500 ? 3 : 0)); // one is the result of rank 1
    }
}

TEST_CASE("an ALT leaves the message of a rank, long or short, until it is chosen") {
    for (const std::size_t length : {1u, 5000u}) {
        const auto alternates = rank_kind<std::vector<int>>("alternates", [length](ProcessEnvironment& environment) {
            if (environment.index() == 0) {
                environment.output<std::vector<int>>("out").output(std::vector<int>(length, 7));
                environment.measure("sent after ms", in_milliseconds(now()), "ms");
                return;
            }
            const auto in = environment.input<std::vector<int>>("in");
            Channel<std::vector<int>> local("local");
            int order = 0;
            par([&] { local.out().output({1}); },
                [&] {
                    wait_for(40ms); // both messages are there
                    alt(on(local.in(), [&](const std::vector<int>&) { order = 10; }),
                        on(in, [&](const std::vector<int>&) { order = 20; }));
                    wait_for(40ms);
                    order += in.input().back();
                });
            environment.measure("order", order);
        });
        const OnRanks run = on_ranks(2, ring_of(2, "alternates"), {alternates});
        REQUIRE_MESSAGE(run.report, what_was_thrown(run));
        CHECK(run.report->result.ending == Ending::completed);
        CHECK(run.report->measured("p[1]", "order") == 17);
        CHECK(run.report->measured("p[0]", "sent after ms") >= 75); // the outputter waited: the channel is synchronous
    }
}

TEST_CASE("a message that no process takes does not keep the run from its end") {
    for (const std::size_t length : {1u, 5000u}) {
        const auto ignores = rank_kind<std::vector<int>>("ignores", [length](ProcessEnvironment& environment) {
            if (environment.index() == 0)
                environment.output<std::vector<int>>("out").output(std::vector<int>(length, 7));
        });
        const OnRanks run = on_ranks(2, ring_of(2, "ignores"), {ignores});
        REQUIRE(run.report);
        CHECK(run.report->result.ending == Ending::stuck);
        CHECK(run.report->result.deadlock->channels.front().inputter == "p[1] (has ended)");
    }
}

TEST_CASE("what a process throws ends all ranks, and names the rank, the process and its place") {
    const auto failing = rank_kind("failing", [](ProcessEnvironment& environment) {
        if (environment.process() == "p[2]") {
            wait_for(5ms);
            throw UserError("there is no sand in this box");
        }
        environment.input<int>("in").input();
    });
    const std::string what = what_was_thrown(on_ranks(3, ring_of(3, "failing"), {failing}));
    CHECK(what.starts_with("rank 2: "));
    CHECK(what.find("process p[2] (failing) at ") != std::string::npos);
    CHECK(what.ends_with("there is no sand in this box"));
}

TEST_CASE("an interruption of ranks ends processes that compute, and that of one rank ends those that wait") {
    for (const bool all : {true, false}) {
        const auto busy = rank_kind("busy", [all](ProcessEnvironment& environment) {
            if (environment.index() == 0)
                for (;;)
                    all ? compute(Cycles{1}) : wait_for(1ms);
            environment.input<int>("in").input();
        });
        const OnRanks run =
            on_ranks(3, ring_of(3, "busy"), {busy}, {.interrupted = all ? Interrupted::all : Interrupted::last});
        REQUIRE(run.report);
        CHECK(run.report->result.ending == Ending::interrupted);
        CHECK(run.report->result.time < Time(5s));
    }
}

TEST_CASE("processes on ranks wait for the end of the work again and again") {
    const auto again = rank_kind("again", [](ProcessEnvironment& environment) {
        if (environment.index() == 1) {
            int sum = 0;
            for (int i = 0; i < 3; ++i)
                sum += environment.input<int>("in").input();
            environment.measure("sum", sum);
        } else if (environment.index() == 0) {
            for (int i = 1; i <= 3; ++i) {
                wait_until_work_is_over();
                environment.output<int>("out").output(i);
            }
        }
    });
    for (const int ranks : {1, 2, 3}) {
        const OnRanks run = on_ranks(ranks, ring_of(3, "again"), {again});
        REQUIRE(run.report);
        CHECK(run.report->result.ending == Ending::completed);
        CHECK(run.report->measured("p[1]", "sum") == 6);
    }
}

TEST_CASE("an input from another rank can be given up, and an output cannot") {
    const auto hasty = rank_kind("hasty", [](ProcessEnvironment& environment) {
        if (environment.index() == 0) {
            wait_for(20ms);
            environment.output<int>("out").output(5);
            return;
        }
        const auto in = environment.input<int>("in");
        int given_up = 0, got = 0;
        while (!input_or_fail(in, got, now() + 2ms)) {
            ++given_up;
            reset(in);
        }
        environment.measure("given up", given_up);
        environment.measure("got", got);
    });
    const OnRanks run = on_ranks(2, ring_of(2, "hasty"), {hasty});
    REQUIRE_MESSAGE(run.report, what_was_thrown(run));
    CHECK(run.report->measured("p[1]", "got") == 5);
    CHECK(run.report->measured("p[1]", "given up") >= 1);

    const auto gives_up = rank_kind("gives_up", [](ProcessEnvironment& environment) {
        if (environment.index() == 0)
            output_or_fail(environment.output<int>("out"), 1, now() + 1ms);
    });
    CHECK(what_was_thrown(on_ranks(2, ring_of(2, "gives_up"), {gives_up}))
              .find("an output to another rank of mpirun cannot be abandoned") != std::string::npos);
}

namespace {

struct Unpackable {
    std::vector<int> numbers;
    WireForm wire_form() const { return WireForm(4u); }
};

} // namespace

TEST_CASE("messages that cannot be packed, and too many ranks, are refused before the run") {
    const auto odd = rank_kind<Unpackable>("odd", [](ProcessEnvironment&) { FAIL("the run has begun"); });
    const std::string what = what_was_thrown(on_ranks(2, ring_of(2, "odd"), {odd}));
    CHECK(what.find("the channel \"p[0].out -> p[1].in\" from the port \"out\" of kind \"odd\" leads to another rank, "
                    "but its messages cannot be packed") != std::string::npos);
    CHECK(what_was_thrown(on_ranks(3, ring_of(2, "csp.identity"), {})).find("start at most") != std::string::npos);
}

TEST_CASE("an interruption while ranks find their loads ends all of them before the run") {
    const auto idle = rank_kind("idle", [](ProcessEnvironment&) {});
    CHECK(
        what_was_thrown(on_ranks(2, ring_of(2, "idle"), {idle}, {.interrupted = Interrupted::all, .balances = true})) ==
        "interrupted before the run began");
}
