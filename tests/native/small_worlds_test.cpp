// Tests every network of three processes with a few actions each, on threads: the runtime does only what CSP allows.

#include "tests/native/native_world.hpp"
#include "tests/runtime/every_world.hpp"
#include "tests/sanitized.hpp"

#include <doctest/doctest.h>

#include <array>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

/// The thread of each process.
using Threads = std::array<std::size_t, 3>;
constexpr std::array<Threads, 4> all_threads{Threads{0, 1, 2}, Threads{0, 0, 1}, Threads{0, 1, 0}, Threads{0, 1, 1}};

void check_course(const SmallWorld& world, const Threads& threads) {
    NativeWorld run(world, {threads.begin(), threads.end()});
    const bool completed = run.run();
    if (!Interpreter(world).allows(run.trace(), completed))
        FAIL(world.text(), " on threads ", threads[0], threads[1], threads[2], " did ", run.trace(),
             completed ? " and completed" : " and got stuck");
}

std::size_t check_all(const Bounds& bounds) {
    std::size_t worlds = 0;
    for_every_world(bounds, [&](const SmallWorld& world) {
        check_course(world, all_threads[0]);
        check_course(world, all_threads[1 + worlds++ % 3]);
    });
    return worlds;
}

} // namespace

TEST_CASE("every world of up to two actions a process takes a course that CSP allows, on two and on three threads") {
    if (test::sanitized)
        return void(check_all({1}));
    CHECK(check_all({2}) == 1233);
    CHECK(check_all({.longest = 2, .any_guards = true}) > 1233);
}

TEST_CASE("all worlds of up to three actions take a course that CSP allows, on threads" * doctest::skip()) {
    CHECK(check_all({3}) == 65824);
}
