// Tests that misuse of the library is reported at once.

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/stack_arena.hpp"
#include "runtime/timer.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <thread>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;

namespace {

constexpr const char* no_process = "only a process of a running simulation can communicate, compute or wait";

constexpr const char* used_up =
    " has used up its stack of 256 Kbyte: it calls itself without end, or has large arrays, "
    "which belong on the heap (std::vector)\n";

/// Returns the message that a simulation of only this process throws.
std::string refusal_of(Process::Body body) {
    Simulation simulation;
    simulation.process("p", std::move(body));
    try {
        simulation.run();
    } catch (const std::logic_error& refused) {
        return refused.what();
    }
    return "";
}

/// The end of a program that ran in its own operating-system process.
struct Death {
    int signal = 0; ///< 0 if no signal ended it
    std::string errors;
};

template <class Program>
Death die(Program program) {
    std::array<int, 2> errors{};
    REQUIRE(pipe(errors.data()) == 0);
    pid_t child = fork();
    if (child == 0) {
        std::signal(SIGABRT, SIG_DFL);
        std::signal(SIGSEGV, SIG_DFL);
        dup2(errors[1], STDERR_FILENO);
        close(errors[0]);
        alarm(20);
        program();
        _exit(0);
    }
    close(errors[1]);
    Death death;
    std::array<char, 1000> text{};
    for (ssize_t count; (count = read(errors[0], text.data(), text.size())) > 0;)
        death.errors.append(text.data(), static_cast<std::size_t>(count));
    close(errors[0]);
    int status = 0;
    waitpid(child, &status, 0);
    death.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return death;
}

/// Recurses without end.
int recurse(int depth) { // NOLINT(misc-no-recursion)
    volatile int here = depth;
    return depth < 0 ? 0 : recurse(depth + 1) + here;
}

/// Uses slightly more than the stack.
void overflow_a_little() {
    std::array<volatile char, Stack::usual_bytes> large;
    for (std::size_t i = 0; i < large.size(); ++i)
        large[i] = 1;
}

/// Writes only to the two ends of an array, because other stacks may lie between them. The pointer is volatile, so that
/// the optimiser cannot remove the writes.
void (*volatile write_ends)(char*, std::size_t) = [](char* array, std::size_t bytes) {
    array[0] = array[bytes - 1] = 1;
};

template <std::size_t bytes>
void write_local() {
    char large[bytes];
    write_ends(large, bytes);
}

void write_allocated(std::size_t bytes) { write_ends(static_cast<char*>(__builtin_alloca(bytes)), bytes); }

constexpr std::size_t stack_and_zone = Stack::usual_bytes + Stack::zone_bytes;

struct LargeArray {
    const char* what;
    void (*write)();
};
/// Arrays that end in the guard zone or beyond it. Beyond it are the variables of the process on the next stack.
constexpr LargeArray large_arrays[] = {
    {"the zone's", [] { write_local<Stack::usual_bytes + 1000>(); }},
    {"beyond the zone", [] { write_local<stack_and_zone + 12'000>(); }},
    {"two stacks", [] { write_local<2 * stack_and_zone>(); }},
    {"1 Mbyte", [] { write_local<1'000'000>(); }},
    {"5 Mbyte", [] { write_local<5'000'000>(); }},
    {"alloca, beyond the zone", [] { write_allocated(stack_and_zone + 12'000); }},
    {"alloca, 5 Mbyte", [] { write_allocated(5'000'000); }},
};

} // namespace

TEST_CASE("outside of a run, communicating, computing and waiting are refused") {
    Channel<int> c("c");
    CHECK_THROWS_WITH_AS(c.out().output(1), no_process, std::logic_error);
    CHECK_THROWS_WITH_AS(c.in().input(), no_process, std::logic_error);
    CHECK_THROWS_WITH_AS(alt(on(c.in(), [](int) {})), no_process, std::logic_error);
    CHECK_THROWS_WITH_AS(par([] {}, [] {}), no_process, std::logic_error);
    CHECK_THROWS_WITH_AS(compute(Cycles{1}), no_process, std::logic_error);
    CHECK_THROWS_WITH_AS(wait_for(microseconds{1}), no_process, std::logic_error);
    CHECK_THROWS_WITH_AS(Timer().read(), no_process, std::logic_error);
}

TEST_CASE("the observer of the end of the work cannot compute, because it is not a process") {
    Simulation simulation;
    simulation.process("p", [] {});
    CHECK_THROWS_WITH_AS(simulation.run(Time::max(), [] { compute(Cycles{1}); }), no_process, std::logic_error);
}

TEST_CASE("an end that belongs to no channel is refused") {
    constexpr const char* message = "an end that belongs to no channel is used";
    CHECK(refusal_of([] { Input<int>().input(); }) == message);
    CHECK(refusal_of([] { Output<int>().output(1); }) == message);
    CHECK(refusal_of([] { alt(on(Input<int>(), [](int) {})); }) == message);
}

TEST_CASE("a link without speed or with a negative delay is refused") {
    Simulation simulation;
    CHECK_THROWS_AS(simulation.add<Link>(LinkTiming{.bits_per_second = 0}), std::logic_error);
    CHECK_THROWS_AS(simulation.add<Link>(LinkTiming{.bits_per_second = -1}), std::logic_error);
    CHECK_THROWS_AS(simulation.add<Link>(LinkTiming{.wire_delay = Time{-1}}), std::logic_error);
}

TEST_CASE("a part of a message that is too long for its count is refused") {
    CHECK(WireForm(4u, std::int64_t{4'294'967'295}).total() == 4'294'967'299);
    CHECK_THROWS_AS(WireForm(4u, std::int64_t{5'000'000'000}), std::length_error);
    CHECK_THROWS_AS(WireForm(-1), std::length_error);
}

TEST_CASE("an outputter that the carrier refused has left the channel") {
    struct Nothing {
        WireForm wire_form() const { return WireForm(0); }
    };
    Simulation simulation;
    Channel<Nothing> c("c", simulation.add<Link>().from_a_to_b());
    int refused = 0;
    simulation.process("p", [&] {
        for (int i = 0; i < 2; ++i)
            try {
                c.out().output({});
            } catch (const std::logic_error& error) {
                refused += std::string(error.what()) == "a message without bytes cannot travel on channel c";
            }
    });
    simulation.run();
    CHECK(refused == 2);
    CHECK(!c.output_waits());
}

TEST_CASE("a soft channel between two processors is refused") {
    for (bool outputter_first : {true, false}) {
        Simulation simulation;
        auto& a = simulation.add<Processor>("a");
        auto& b = simulation.add<Processor>("b");
        Channel<std::int64_t> c("c"); // two words: output and input take equally long
        auto output = [&] { c.out().output(1); };
        auto input = [&] { c.in().input(); };
        simulation.process("first", outputter_first ? Process::Body(output) : input, &a);
        simulation.process("second", outputter_first ? Process::Body(input) : output, &b);
        CHECK_THROWS_WITH_AS(simulation.run(),
                             "channel c joins process first on a and process second on b, and no link carries it",
                             std::logic_error);
    }
}

TEST_CASE("an end of a channel has one owner, and other users are refused") {
    Simulation simulation;
    Channel<int> c("c"), go("go");
    SUBCASE("an end that two processes declare") {
        simulation.process("first", {c.out()}, [] {});
        CHECK_THROWS_WITH_AS(
            simulation.process("second", {c.in(), c.out()}, [] {}),
            "process second outputs to channel c, but this end belongs to process first: a channel has one "
            "outputting and one inputting process",
            std::logic_error);
    }
    SUBCASE("an end that another process has declared") {
        simulation.process("first", {c.in()}, [] {});
        simulation.process("second", [&] { c.in().input(); });
        CHECK_THROWS_AS(simulation.run(), std::logic_error);
    }
    SUBCASE("two outputters in turn") {
        simulation.process("first", [&] { c.out().output(1), go.out().output(1); });
        simulation.process("second", [&] { go.in().input(), c.out().output(2); });
        simulation.process("inputter", [&] { c.in().input(), c.in().input(); });
        CHECK_THROWS_WITH_AS(
            simulation.run(),
            "process second outputs to channel c, but this end belongs to process first: a channel has one "
            "outputting and one inputting process",
            std::logic_error);
    }
    SUBCASE("an alternation beside an inputter") {
        simulation.process("first", [&] { c.in().input(), go.out().output(1); });
        simulation.process("second", [&] { go.in().input(), alt(on(c.in(), [](int) {})); });
        simulation.process("outputter", [&] { c.out().output(1), c.out().output(2); });
        CHECK_THROWS_WITH_AS(
            simulation.run(),
            "process second inputs from channel c, but this end belongs to process first: a channel has one "
            "outputting and one inputting process",
            std::logic_error);
    }
    SUBCASE("two components of a PAR in turn") {
        simulation.process("p", [&] {
            par([&] { c.out().output(1), go.out().output(1); }, [&] { go.in().input(), c.out().output(2); });
        });
        simulation.process("inputter", [&] { c.in().input(), c.in().input(); });
        CHECK_THROWS_WITH_AS(
            simulation.run(),
            "process p/1 outputs to channel c, but this end belongs to another component of a PAR: a channel "
            "has one outputting and one inputting process",
            std::logic_error);
    }
    SUBCASE("a process and the components of its PARs, one after the other") {
        simulation.process("p", [&] {
            c.out().output(1);
            for (int i = 0; i < 2; ++i)
                par([&] { c.out().output(2); }, [] {});
            par([] {}, [&] { par([] {}, [&] { c.out().output(3); }); });
            c.out().output(4);
        });
        simulation.process("inputter", [&] {
            for (int i = 0; i < 5; ++i)
                c.in().input();
        });
        CHECK(simulation.run().ending == Ending::completed);
    }
}

TEST_CASE("a component of a PAR may not use an end while a process of another component uses it") {
    Simulation simulation;
    Channel<int> c("c");
    SUBCASE("it outputs") {
        simulation.process("p", [&] {
            par([&] { wait_for(std::chrono::microseconds{20}), c.out().output(1); },
                [&] { par([&] { c.out().output(2); }, [] {}); });
        });
        CHECK_THROWS_WITH_AS(
            simulation.run(),
            "process p/0 outputs to channel c, but this end belongs to another component of a PAR: a channel "
            "has one outputting and one inputting process",
            std::logic_error);
    }
    SUBCASE("its message has gone, but it has not had its turn") {
        Channel<int> a("a");
        simulation.process("p", [&] {
            par([&] { a.in().input(), c.out().output(1); }, [&] { par([&] { c.out().output(2); }, [] {}); });
        });
        simulation.process("inputter", [&] {
            wait_for(std::chrono::microseconds{20});
            a.out().output(0), c.in().input();
        });
        CHECK_THROWS_AS(simulation.run(), std::logic_error);
    }
    SUBCASE("its message has gone, but not been acknowledged") {
        for (int nanoseconds = 50; nanoseconds < 400; nanoseconds += 50) {
            CAPTURE(nanoseconds);
            Simulation each;
            Link& its_link = each.add<Link>();
            Channel<std::uint8_t> byte("byte", its_link.from_a_to_b());
            each.process("p", [&] {
                par([&] { wait_for(std::chrono::nanoseconds{nanoseconds}), byte.out().output(1); },
                    [&] { par([&] { byte.out().output(2); }, [] {}); });
            });
            each.process("inputter", [&] { byte.in().input(), byte.in().input(); });
            CHECK_THROWS_AS(each.run(std::chrono::milliseconds{1}), std::logic_error);
        }
    }
    SUBCASE("it has a guard on it") {
        auto alternate = [&] { alt(on(c.in(), [](int) {}), after(std::chrono::milliseconds{1}, [] {})); };
        simulation.process("p", [&] {
            par([&] { wait_for(std::chrono::microseconds{20}), alternate(); }, [&] { par(alternate, [] {}); });
        });
        CHECK_THROWS_AS(simulation.run(), std::logic_error);
    }
}

TEST_CASE("computing for ever in no time is an error that names the process" * doctest::skip(test::sanitized)) {
    Simulation simulation;
    SUBCASE("not placed") {
        simulation.process("p", [] {
            for (;;)
                compute(Cycles{1});
        });
    }
    SUBCASE("not placed, reading its clock") {
        simulation.process("p", [] {
            for (Timer clock; clock.read() < 5;)
                ;
        });
    }
    SUBCASE("reading the virtual time") {
        simulation.process("p", [] {
            while (now() < microseconds{1})
                ;
        });
    }
    SUBCASE("placed") {
        simulation.process(
            "p",
            [] {
                for (;;)
                    compute(Cycles{0});
            },
            &simulation.add<Processor>("t800"));
    }
    CHECK_THROWS_WITH_AS(simulation.run(microseconds{1}), "process p computes for ever without any time passing",
                         std::logic_error);
}

TEST_CASE("computing in no time can be interrupted") {
    Simulation simulation;
    std::thread other;
    simulation.process("p", [&] {
        other = std::thread([&] { simulation.interrupt(); });
        for (;;)
            compute(Cycles{1});
    });
    CHECK(simulation.run().ending == Ending::interrupted);
    other.join();
}

TEST_CASE("a process that catches all exceptions ends the program with a message instead of hanging it") {
    Death death = die([] {
        Simulation simulation;
        Channel<int> c("c");
        simulation.process("p", [&] {
            for (;;)
                try {
                    c.in().input();
                } catch (...) {
                }
        });
        simulation.run();
    });
    CHECK(death.signal == SIGABRT);
    CHECK(death.errors == "process p catches every exception, including the one that ends it: rethrow Unwinding\n");
}

TEST_CASE("a stack that the thread kept from an earlier run is zeroed and guarded as any other") {
    if (SwitchedStack::is_watched())
        return; // no stacks are kept in this case
    std::byte* kept = StackArena().allocate().bottom;
    StackArena next;
    if (Stack stack = next.allocate(); stack.guarded) {
        CHECK(stack.bottom == kept);
        CHECK(next.allocate().bottom != kept);
        CHECK(StackArena().allocate().bottom != kept);
    }
    Death death = die([] {
        for (bool last : {false, true}) {
            Simulation simulation;
            simulation.process("recursive", [last] {
                if (last)
                    recurse(0);
            });
            simulation.run();
        }
    });
    CHECK(death.signal == SIGSEGV);
    CHECK(death.errors.starts_with("process recursive has used up its stack"));
}

TEST_CASE("a stack overflow is reported with the name of its process") {
    if (SwitchedStack::is_watched())
        return; // AddressSanitizer prints its own report
    SUBCASE("a process") {
        Death death = die([] {
            Simulation simulation;
            simulation.process("recursive", [] { recurse(0); });
            simulation.run();
        });
        CHECK(death.signal == SIGSEGV);
        CHECK(death.errors == std::string("process recursive") + used_up);
    }
    SUBCASE("a component of a PAR") {
        Death death = die([] {
            Simulation simulation;
            simulation.process("recursive", [] { par([] {}, [] { recurse(0); }); });
            simulation.run();
        });
        CHECK(death.signal == SIGSEGV);
        CHECK(death.errors == std::string("a component of process recursive") + used_up);
    }
    SUBCASE("one of so many stacks that before Linux 6.13 not all are guarded") {
        StackArena arena;
        Stack last;
        for (int i = 0; i <= 16'000; ++i)
            last = arena.allocate();
        Death death = die([] {
            Simulation simulation;
            Channel<int> never("never");
            for (int i = 0; i < 16'000; ++i)
                simulation.process("waits", [] { wait_for(microseconds{9}); });
            simulation.process("recursive", [&] { overflow_a_little(), never.in().input(); });
            simulation.run();
        });
        CHECK(death.signal == (last.guarded ? SIGSEGV : SIGABRT)); // at once, or when the process waits
        CHECK(death.errors == std::string("process recursive") + used_up);
    }
    SUBCASE("one of so many stacks, which a recursion overflows through the others") {
        Death death = die([] {
            Simulation simulation;
            for (int i = 0; i < 16'010; ++i)
                simulation.process("waits", [] { wait_for(microseconds{9}); });
            simulation.process("recursive", [] { recurse(0); });
            simulation.run();
        });
        CHECK(death.signal == SIGSEGV);
        CHECK(death.errors == std::string("process recursive") + used_up);
    }
    SUBCASE("another fault is not reported as an overflow") {
        Death death = die([] {
            Simulation simulation;
            simulation.process("careless", [] { *static_cast<volatile int*>(nullptr) = 1; });
            simulation.run();
        });
        CHECK(death.signal == SIGSEGV);
        CHECK(death.errors == "");
    }
}

TEST_CASE("a stack overflow by an array larger than the guard zone is reported with the name of its process") {
    if (SwitchedStack::is_watched())
        return; // AddressSanitizer prints its own report
    for (const LargeArray& large : large_arrays) {
        CAPTURE(large.what);
        Death death = die([&] {
            Simulation simulation;
            for (int i = 0; i < 20; ++i) // provides memory for the largest array
                simulation.process("waits", [] { wait_for(microseconds{9}); });
            simulation.process("large", [&] { large.write(); });
            simulation.run();
        });
        CHECK(death.signal == SIGSEGV);
        CHECK(death.errors == std::string("process large") + used_up);
    }
}

TEST_CASE("a failed run names the process, the time and the place") {
    Simulation simulation;
    Channel<int> c("c");
    simulation.process("cluster[0].p", [&] {
        par(
            [&] {
                wait_for(microseconds{7});
                throw std::runtime_error("worn out");
            },
            [&] { c.in().input(); });
    });
    CHECK_THROWS_WITH_AS(simulation.run(), "worn out", std::runtime_error);
    REQUIRE(simulation.who_failed());
    CHECK(simulation.who_failed()->process == "cluster[0].p/0");
    CHECK(simulation.who_failed()->time == microseconds{7});
    CHECK(simulation.who_failed()->where.starts_with("misuse_test.cpp:"));
}
