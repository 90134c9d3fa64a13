// Tests that the stacks of all processes are unwound however a simulation ends, and that another simulation can follow.

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/router.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

#include <boost/fiber/all.hpp>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <thread>
#include <utility>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;

namespace {

struct Counted {
    explicit Counted(int& n) : alive(n) { ++alive; }
    ~Counted() { --alive; }
    Counted(const Counted&) = delete;
    int& alive;
};

/// Processes in every kind of wait, each with an object on its stack. Another process calls `last` at 5 us.
class Waiters {
public:
    explicit Waiters(std::function<void()> last) {
        Processor& t800 = simulation.add<Processor>("t800");
        hard.put_on(simulation.add<Link>().from_a_to_b());
        RouterLink& link = simulation.add<RouterLink>(simulation.add<Link>(), simulation.add<Router>(&t800),
                                                      simulation.add<Router>(nullptr));
        virtual_one.put_on(simulation.add<Route>(std::vector{Hop{link, true}}));
        add([this] { soft.in().input(); });
        add([this] { other.out().output(1); });
        add([this] { hard.out().output(1); });
        add([this] { alt(on(third.in(), [](int) {}), on(fourth.in(), [](int) {})); });
        add([this] { virtual_one.out().output(1); }, &t800);
        add([this] {
            par(
                [this] {
                    Counted inner(alive);
                    fifth.in().input();
                },
                [this] {
                    Counted inner(alive);
                    sixth.out().output(1);
                });
        });
        add([] { wait_for(microseconds{3}); });
        add([last = std::move(last)] { wait_for(microseconds{5}), last(); });
    }

    Simulation simulation;
    int alive = 0;
    int started = 0;

private:
    void add(std::function<void()> body, Processor* on = nullptr) {
        simulation.process(
            "waiter",
            [this, body = std::move(body)] {
                ++started;
                Counted counted(alive);
                body();
            },
            on);
    }
    Channel<int> soft{"soft"}, other{"other"}, hard{"hard"}, third{"third"}, fourth{"fourth"}, fifth{"fifth"},
        sixth{"sixth"}, virtual_one{"virtual"};
};

} // namespace

TEST_CASE("processes are unwound when the run is stuck") {
    Waiters waiters([] {});
    CHECK(waiters.simulation.run().ending == Ending::stuck);
    CHECK(waiters.started == 8);
    CHECK(waiters.alive == 0);
}

TEST_CASE("processes are unwound at the time limit, which is then the virtual time") {
    Waiters waiters([] {});
    RunResult result = waiters.simulation.run(microseconds{4});
    CHECK(result.ending == Ending::time_limit);
    CHECK(result.time == microseconds{4});
    CHECK(waiters.alive == 0);
}

TEST_CASE("processes are unwound when a process throws, and the run rethrows the exception") {
    Waiters waiters([] { throw std::runtime_error("the pump is dry"); });
    CHECK_THROWS_WITH_AS(waiters.simulation.run(), "the pump is dry", std::runtime_error);
    CHECK(waiters.alive == 0);
}

TEST_CASE("processes are unwound when a component of a PAR throws on a processor") {
    Waiters waiters([] { par([] { wait_for(microseconds{1}); }, [] { throw std::runtime_error("component"); }); });
    CHECK_THROWS_WITH_AS(waiters.simulation.run(), "component", std::runtime_error);
    CHECK(waiters.alive == 0);
}

TEST_CASE("processes are unwound when the run is interrupted") {
    Waiters* self = nullptr;
    Waiters waiters([&self] { self->simulation.interrupt(), wait_for(microseconds{1}); });
    self = &waiters;
    CHECK(waiters.simulation.run().ending == Ending::interrupted);
    CHECK(waiters.alive == 0);
}

TEST_CASE("a destructor may read the clock after an interruption and during unwinding") {
    struct Watch {
        std::vector<Time>& ends;
        ~Watch() { ends.push_back(now()); }
    };
    Simulation simulation;
    std::vector<Time> ends;
    simulation.process("p", [&] {
        Watch whole{ends};
        wait_for(microseconds{1});
        {
            Watch part{ends};
            simulation.interrupt();
        }
        wait_for(microseconds{1});
    });
    CHECK(simulation.run().ending == Ending::interrupted);
    CHECK(ends == std::vector<Time>{microseconds{1}, microseconds{1}});
}

TEST_CASE("processes are unwound when the observer of the end throws") {
    Kernel kernel;
    int alive = 0;
    Channel<int> c("c");
    Process waiter(
        kernel, "waiter",
        [&] {
            Counted counted(alive);
            c.in().input();
        },
        nullptr, Priority::low);
    kernel.make_ready(waiter);
    CHECK_THROWS_AS(kernel.run(Time::max(), {.run_over = [](Ending) { throw std::runtime_error("report"); }}),
                    std::runtime_error);
    CHECK(alive == 0);
    CHECK(Kernel::current() == nullptr);
}

TEST_CASE("a run of a process that only computes can be interrupted from another thread") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    std::atomic<bool> computing = false;
    simulation.process(
        "computes forever",
        [&] {
            for (;; computing = true)
                compute(Cycles{1});
        },
        &t800);
    std::thread other([&] {
        while (!computing)
            std::this_thread::yield();
        simulation.interrupt();
    });
    CHECK(simulation.run().ending == Ending::interrupted);
    other.join();
}

TEST_CASE("a process that swallows its unwinding is unwound at its next wait") {
    Simulation simulation;
    Processor& t800 = simulation.add<Processor>("t800");
    Channel<int> c("c");
    int swallowed = 0;
    simulation.process(
        "stubborn",
        [&] {
            for (int i = 0; i < 3; ++i)
                try {
                    compute(Cycles{1});
                    par([&] { c.in().input(); });
                } catch (...) {
                    ++swallowed;
                }
        },
        &t800);
    CHECK(simulation.run().ending == Ending::stuck);
    CHECK(swallowed == 3);
}

TEST_CASE("a process that swallows its unwinding takes no further part in messages on links") {
    Simulation simulation;
    Link& link = simulation.add<Link>();
    int swallowed = 0;
    auto thrice = [&swallowed](auto communicate) {
        for (int i = 0; i < 3; ++i)
            try {
                communicate();
            } catch (...) {
                ++swallowed;
            }
    };
    SUBCASE("it would take a message whose sender is gone") {
        Channel<std::uint8_t> c("c", link.from_a_to_b());
        simulation.process("takes", [&] {
            thrice([&, first = true]() mutable {
                if (std::exchange(first, false))
                    wait_for(std::chrono::milliseconds{2});
                c.in().input();
            });
        });
        simulation.process("sends", [&] { c.out().output(1); });
        CHECK(simulation.run(std::chrono::milliseconds{1}).ending == Ending::time_limit);
    }
    SUBCASE("it would send while its last message is on the link") {
        Channel<std::array<std::uint8_t, 1000>> c("c", link.from_a_to_b());
        simulation.process("takes", [&] { c.in().input(); });
        simulation.process("sends", [&] { thrice([&] { c.out().output({}); }); });
        CHECK(simulation.run(microseconds{100}).ending == Ending::time_limit);
    }
    SUBCASE("it would send to a process that no longer waits") {
        Channel<int> c("c");
        simulation.process("takes", [&] { c.in().input(); });
        simulation.process("sends", [&] {
            thrice([&, first = true]() mutable {
                if (std::exchange(first, false))
                    wait_for(std::chrono::milliseconds{2});
                c.out().output(1);
            });
        });
        CHECK(simulation.run(std::chrono::milliseconds{1}).ending == Ending::time_limit);
    }
    CHECK(swallowed == 3);
}

TEST_CASE("a device that never stops does not keep a run from completing") {
    Simulation simulation;
    int polls = 0, alive = 0;
    simulation
        .process("device",
                 [&] {
                     for (Counted counted(alive);; ++polls)
                         wait_for(microseconds{1});
                 })
        .serve_machine();
    simulation.process("program", [] { wait_for(microseconds{100}); });
    RunResult result = simulation.run();
    CHECK(result.ending == Ending::completed);
    CHECK(result.time == microseconds{100});
    CHECK(polls >= 99);
    CHECK(alive == 0);
}

TEST_CASE("processes that never had a turn are not started to be unwound") {
    Simulation simulation;
    bool started = false;
    simulation.process("throws", [] { throw std::runtime_error("first"); });
    simulation.process("never", [&] { started = true; });
    CHECK_THROWS_AS(simulation.run(), std::runtime_error);
    CHECK_FALSE(started);
}

TEST_CASE("a simulation can be destroyed without a run, runs only once, and does not run within another") {
    {
        Simulation unused;
        unused.process("never", [] {});
    }
    Simulation simulation;
    bool refused = false;
    simulation.process("nests", [&] {
        Simulation inner;
        try {
            inner.run();
        } catch (const std::logic_error&) {
            refused = true;
        }
    });
    simulation.run();
    CHECK(refused);
    CHECK_THROWS_AS(simulation.run(), std::logic_error);
}

TEST_CASE("a hundred simulations in sequence, and one on each of two threads, have the same fingerprint") {
    auto fingerprint = [] {
        Waiters waiters([] {});
        return waiters.simulation.run().fingerprint;
    };
    std::uint64_t expected = fingerprint();
    for (int i = 0; i < 100; ++i)
        CHECK(fingerprint() == expected);
    std::uint64_t on_thread[2] = {};
    std::thread first([&] { on_thread[0] = fingerprint(); }), second([&] { on_thread[1] = fingerprint(); });
    first.join(), second.join();
    CHECK(on_thread[0] == expected);
    CHECK(on_thread[1] == expected);
}

TEST_CASE("a simulation can run on a Boost fiber of the host program, whose other fibers rest meanwhile") {
    std::string order;
    boost::fibers::fiber host([&] {
        Simulation simulation;
        Channel<int> c("c");
        simulation.process("outputter", [&] { wait_for(microseconds{1}), c.out().output(1); });
        simulation.process("inputter", [&] { order += c.in().input() == 1 ? "simulation " : "wrong "; });
        CHECK(simulation.run().ending == Ending::completed);
        order += "host ";
    });
    boost::fibers::fiber other([&] { order += "other "; });
    host.join();
    other.join();
    CHECK(order.find("simulation") == 0);
    CHECK(order.find("other") != std::string::npos);
    CHECK(order.find("host") != std::string::npos);
}
