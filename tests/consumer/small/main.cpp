// The smallest program that uses a channel, a PAR, an ALT, a timer, an exception and the report of a deadlock.
// With the arguments `array BYTES` or `alloca BYTES`, a process of the program has a local array of that size.

#include "placedpar/runtime/alternation.hpp"
#include "placedpar/runtime/parallel.hpp"
#include "placedpar/runtime/simulation.hpp"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

using namespace placedpar;

namespace {

constexpr auto moment = std::chrono::microseconds{1};

int failures = 0;

void require(bool holds, const char* what) {
    if (!holds)
        std::printf("%s does not hold\n", what), ++failures;
}

void communicate() {
    Simulation simulation;
    Channel<int> a("a"), b("b");
    int sum = 0;
    simulation.process("sender",
                       [&] { par([&] { a.out().output(1); }, [&] { wait_for(moment), b.out().output(2); }); });
    simulation.process("receiver", [&] {
        for (int i = 0; i < 2; ++i)
            alt(on(a.in(), [&](int n) { sum += n; }), on(b.in(), [&](int n) { sum += n; }));
    });
    require(simulation.run().ending == Ending::completed && sum == 3, "two messages arrive");
}

void throw_and_catch() {
    Simulation simulation;
    simulation.process("catches", [] {
        for (int i = 0; i < 3; ++i)
            try {
                wait_for(moment);
                throw std::runtime_error("caught");
            } catch (const std::runtime_error&) {
            }
    });
    require(simulation.run().ending == Ending::completed, "a process catches");
    Simulation failing;
    failing.process("throws", [] { wait_for(moment), throw std::runtime_error("of the process"); });
    std::string text;
    try {
        failing.run();
    } catch (const std::runtime_error& error) {
        text = error.what();
    }
    require(text == "of the process", "a run throws what its process threw");
}

void deadlock() {
    Simulation simulation;
    Channel<int> c("c");
    simulation.process("waits", [&] {
#line 1 "place.cpp"
        c.in().input();
    });
    RunResult result = simulation.run();
    require(result.deadlock && result.deadlock->text().find("place.cpp:1") != std::string::npos, "the place is named");
}

/// The pointer is volatile, so that the optimiser cannot remove the writes.
void (*volatile write_ends)(char*, std::size_t) = [](char* array, std::size_t bytes) {
    array[0] = array[bytes - 1] = 1;
};

template <std::size_t bytes>
[[gnu::noinline]] void write_array() {
    char local[bytes];
    write_ends(local, bytes);
}

void write_local(const std::string& how, std::size_t bytes) {
    if (how == "alloca")
        write_ends(static_cast<char*>(__builtin_alloca(bytes)), bytes);
    else if (bytes == 100'000)
        write_array<100'000>();
    else if (bytes == 340'000)
        write_array<340'000>();
    else
        write_array<4'000'000>();
}

/// Runs "large" among 20 other processes, so that their stacks lie next to its stack.
int overflow(const std::string& how, std::size_t bytes) {
    Simulation simulation;
    for (int i = 0; i < 20; ++i)
        simulation.process("other", [] {
            volatile int own = 1;
            wait_for(moment);
            require(own == 1, "a process keeps its variables");
        });
    simulation.process("large", [&] { write_local(how, bytes); });
    simulation.run();
    return failures;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 3)
        return overflow(argv[1], std::strtoul(argv[2], nullptr, 10));
    communicate();
    throw_and_catch();
    deadlock();
    return failures;
}
