// Two processes exchange a number over and over: on one kernel, and on two kernels in two threads. The program prints
// nanoseconds of the wall clock for a message there and back.

#include "native/crossing.hpp"
#include "native/group.hpp"
#include "runtime/simulation.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <deque>
#include <list>
#include <stdexcept>
#include <thread>
#include <vector>

using namespace placedpar;

namespace {

/// The halves of a channel; one if both processes are on one thread.
struct Halves {
    Channel<long> output, input;
    explicit Halves(const char* name) : output(name), input(name) {}
};

double nanoseconds_there_and_back(std::size_t threads, long times) {
    std::deque<Simulation> simulations(threads);
    native::Group group;
    for (Simulation& simulation : simulations)
        group.add(simulation);
    Halves there("there"), back("back");
    std::list<native::Crossing> crossings;
    if (threads == 2) {
        crossings.emplace_back(there.output, group.member(0), there.input, group.member(1));
        crossings.emplace_back(back.output, group.member(1), back.input, group.member(0));
    }
    Channel<long>&there_in = threads == 2 ? there.input : there.output,
    &back_in = threads == 2 ? back.input : back.output;
    long last = 0;
    simulations.front().process("ping", [&] {
        for (long i = 0; i < times; ++i) {
            there.output.out().output(i);
            last = back_in.in().input();
        }
    });
    simulations.back().process("pong", [&] {
        for (long i = 0; i < times; ++i)
            back.output.out().output(there_in.in().input() + 1);
    });
    const auto begun = std::chrono::steady_clock::now();
    {
        std::vector<std::jthread> running;
        for (Simulation& simulation : simulations)
            running.emplace_back([&simulation] { simulation.run(); });
    }
    if (last != times)
        throw std::logic_error("the numbers did not come back");
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begun).count() /
           static_cast<double>(times);
}

} // namespace

int main(int arguments, char** argument) {
    const long times = arguments > 1 ? std::atol(argument[1]) : 1'000'000;
    for (const std::size_t threads : {std::size_t{1}, std::size_t{2}})
        fmt::print("{} {}: {:.0f} ns there and back\n", threads, threads == 1 ? "thread" : "threads",
                   nanoseconds_there_and_back(threads, times));
}
