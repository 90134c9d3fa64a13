#include "explore/workers.hpp"

#include "explore/runs_at_once.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace placedpar;
using namespace std::chrono_literals;

TEST_CASE("each worker is called once, with its number") {
    std::vector<std::atomic<int>> calls(5);
    on_workers(calls.size(), [&](std::size_t worker) { ++calls[worker]; });
    for (const auto& each : calls)
        CHECK(each == 1);
    on_workers(0, [](std::size_t) { FAIL("nobody is there"); });
}

TEST_CASE("the caller's function runs while workers work") {
    std::atomic<bool> seen = false;
    on_workers(
        1,
        [&](std::size_t) {
            while (!seen)
                std::this_thread::sleep_for(1ms);
        },
        [&] { seen = true; }, 1ms);
    CHECK(seen);
}

TEST_CASE("the exception of the first worker is rethrown when all workers have ended") {
    std::atomic<int> ended = 0;
    auto work = [&](std::size_t worker) {
        std::this_thread::sleep_for(worker == 0 ? 0ms : 20ms);
        ++ended;
        throw std::runtime_error("worker " + std::to_string(worker));
    };
    CHECK_THROWS_WITH_AS(on_workers(3, work), "worker 0", std::runtime_error);
    CHECK(ended == 3);
}

TEST_CASE("every piece of work is done once, however many pieces there are") {
    for (std::size_t pieces : {std::size_t{0}, std::size_t{1}, 3 * count_cores() + 1}) {
        std::vector<std::atomic<int>> done(pieces);
        const Interruption none;
        run_at_once(
            pieces, [&](std::size_t piece, Interruption&) { ++done[piece]; }, none, [](std::size_t) {});
        for (const auto& each : done)
            CHECK(each == 1);
    }
}

TEST_CASE("an interruption reaches running pieces and prevents further pieces") {
    Interruption interruption;
    std::atomic<std::size_t> begun = 0;
    auto work = [&](std::size_t, Interruption& own) {
        ++begun;
        interruption.request();
        while (!own.requested())
            std::this_thread::sleep_for(1ms);
    };
    run_at_once(10 * count_cores(), work, interruption, [](std::size_t) {});
    CHECK(begun <= count_cores());
}

TEST_CASE("no piece begins if the interruption comes before the first") {
    Interruption interruption;
    interruption.request();
    std::atomic<int> begun = 0;
    run_at_once(
        100, [&](std::size_t, Interruption&) { ++begun; }, interruption, [](std::size_t) {});
    CHECK(begun == 0);
}

TEST_CASE("no more pieces of work are done at a time than the caller allows") {
    const Interruption none;
    std::atomic<int> now = 0, most = 0;
    auto work = [&](std::size_t, Interruption&) {
        most = std::max<int>(most, ++now);
        std::this_thread::sleep_for(1ms);
        --now;
    };
    run_at_once(
        8, work, none, [](std::size_t) {}, 1);
    CHECK(most == 1);
}

TEST_CASE("the exception of a piece of work is rethrown when the others have ended") {
    std::atomic<int> done = 0;
    const Interruption none;
    auto work = [&](std::size_t piece, Interruption&) {
        if (piece == 0)
            throw std::runtime_error("the first piece");
        ++done;
    };
    CHECK_THROWS_WITH_AS(run_at_once(4, work, none, [](std::size_t) {}), "the first piece", std::runtime_error);
    CHECK(done == (count_cores() > 1 ? 3 : 0)); // a single worker stops at the piece that throws
}
