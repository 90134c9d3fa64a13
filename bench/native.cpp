// Two processes exchange a number over and over: on one kernel, and on two kernels in two threads. The program prints
// nanoseconds of the wall clock for a message there and back.

#include "native/ping_pong.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdlib>

using namespace placedpar;

int main(int arguments, char** argument) {
    const long times = arguments > 1 ? std::atol(argument[1]) : 1'000'000;
    for (const std::size_t threads : {std::size_t{1}, std::size_t{2}})
        fmt::print("{} {}: {:.0f} ns there and back\n", threads, threads == 1 ? "thread" : "threads",
                   native::nanoseconds_there_and_back({.kernels = threads, .times = times}));
}
