// The communication-time benchmark of the occam tradition (P. Welch, "commstime"): the processes prefix, delta,
// successor and consumer form a ring. Each loop has four communications, which count as four events. The program prints
// nanoseconds of processor time per loop, first with all communications at one instant of virtual time and then with
// time passing in every loop.

#include "bench/measure.hpp"
#include "runtime/channel.hpp"
#include "runtime/kernel.hpp"
#include "runtime/parallel.hpp"
#include "runtime/timer.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>

using namespace placedpar;
using namespace placedpar::bench;

namespace {

struct Timing {
    double nanoseconds_per_loop, bytes_per_process;
    std::uint64_t fingerprint;
};

/// Runs the benchmark. `pause` is the time for which each of the four processes waits in every loop.
Timing commstime(long loops, Time pause) {
    double before = resident_bytes(), after = 0;
    Kernel kernel;
    Channel<long> a("a"), b("b"), c("c"), d("d");
    auto rest = [pause] {
        if (pause > Time{0})
            wait_for(pause);
    };
    auto prefix = [&] {
        a.out().output(0);
        for (long i = 0; i < loops; ++i) {
            long x = b.in().input();
            rest();
            if (i + 1 < loops)
                a.out().output(x);
        }
    };
    auto delta = [&] {
        for (long i = 0; i < loops; ++i) {
            long x = a.in().input();
            rest();
            c.out().output(x);
            d.out().output(x);
        }
    };
    auto successor = [&] {
        for (long i = 0; i < loops; ++i) {
            long x = c.in().input();
            rest();
            b.out().output(x + 1);
        }
    };
    auto consumer = [&] {
        for (long i = 0; i < loops; ++i) {
            if (d.in().input() != i)
                std::abort();
            rest();
        }
        after = resident_bytes();
    };
    Process main(
        kernel, "commstime", [&] { par(prefix, delta, successor, consumer); }, nullptr, Priority::low);
    kernel.make_ready(main);
    Stopwatch watch;
    kernel.run(Time::max(), {});
    return {watch.nanoseconds() / static_cast<double>(loops), (after - before) / 5, kernel.fingerprint().value()};
}

void measure(const char* what, Time pause, long loops) {
    commstime(loops / 10, pause); // warm-up
    Timing timing;
    in_a_thread_of_its_own([&] { timing = commstime(loops, pause); });
    fmt::print("{:<28} {:7.1f} ns/loop {:7.1f} ns/event   {:8.0f} bytes/process   fingerprint {:016x}\n", what,
               timing.nanoseconds_per_loop, timing.nanoseconds_per_loop / 4, timing.bytes_per_process,
               timing.fingerprint);
}

} // namespace

int main(int argc, char** argv) {
    long loops = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 1'000'000;
    if (loops < 10) {
        fmt::print(stderr, "usage: commstime [LOOPS, at least 10]\n");
        return 1;
    }
    measure("no time passing", Time{0}, loops);
    measure("1 ns passing in each process", std::chrono::nanoseconds{1}, loops);
}
