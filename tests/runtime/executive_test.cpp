// Tests processes on an executive that is not a transputer. The runtime works with any class that implements
// executive.hpp.

#include "runtime/executive.hpp"

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;

namespace {

/// Executes one process until it waits, then the next, in the order in which they become ready. A cycle takes a
/// microsecond, priorities are ignored, and the clock ticks every millisecond.
class Clerk final : public Executive {
public:
    Clerk(Kernel& kernel, std::string name, const OperationCosts& costs)
        : Executive(std::move(name), costs), kernel_(kernel) {}

    Time tick(Priority) const override { return std::chrono::milliseconds{1}; }

    bool begin_computing(Process&, Cycles cycles, const CodeShape&) override {
        spent_.push_back(static_cast<std::int64_t>(cycles));
        kernel_.future().schedule(work_, kernel_.now() + spent_.back() * microseconds{1}, EventQueue::turn);
        return false;
    }
    void make_ready(Process& p) override {
        waiting_.push_back(p);
        if (!current_)
            take_next();
    }
    void leave(Process&, Process* successor) override {
        if (successor)
            waiting_.push_back(*successor);
        take_next();
    }

    /// Returns the cycles of each computation, in order.
    const std::vector<std::int64_t>& spent() const { return spent_; }

private:
    struct Work final : Event {
        explicit Work(Clerk& c) : clerk(c) {}
        void happen() noexcept override { clerk.kernel_.enqueue(*clerk.current_); }
        Clerk& clerk;
    };
    void take_next() {
        current_ = waiting_.pop_front();
        if (current_)
            kernel_.enqueue(*current_);
    }

    Kernel& kernel_;
    ProcessQueue waiting_;
    Process* current_ = nullptr;
    std::vector<std::int64_t> spent_;
    Work work_{*this};
};

/// Each operation costs a different number of cycles.
constexpr OperationCosts costs_of_a_clerk{
    .soft_communication = Cycles{1},
    .soft_word_output = Cycles{50},
    .hard_communication = Cycles{2},
    .copied_word = Cycles{100},
    .bytes_in_a_word = 2,
    .start_component = Cycles{3},
    .end_component = Cycles{4},
    .timer_read = Cycles{5},
    .timer_wait = Cycles{6},
    .timer_wait_past = Cycles{7},
    .alternation_start = Cycles{10},
    .enable_guard = Cycles{20},
    .enable_guard_not_ready = Cycles{15},
    .enable_timeout = Cycles{30},
    .alternation_wait_ready = Cycles{8},
    .alternation_wait = Cycles{9},
    .disable_guard = Cycles{200},
    .disable_timeout = Cycles{300},
    .alternation_end = Cycles{1000},
};

using Spent = std::vector<std::int64_t>;

/// Runs a process alone on a Clerk. Returns the cycles of its computations and of its operations, in order.
Spent spent_by(Process::Body body) {
    Simulation simulation;
    auto& clerk = simulation.add<Clerk>("clerk", costs_of_a_clerk);
    simulation.process("process", std::move(body), &clerk);
    CHECK(simulation.run().ending == Ending::completed);
    return clerk.spent();
}

} // namespace

TEST_CASE("an executive divides its time by its own rules, in cycles of its own length") {
    Simulation simulation;
    auto& clerk = simulation.add<Clerk>("clerk", costs_of_a_clerk);
    std::string order;
    auto work = [&](char name) {
        return [&order, name] {
            for (int i = 0; i < 2; ++i)
                compute(Cycles{5}), order += name;
        };
    };
    simulation.process("a", work('a'), &clerk, Priority::low);
    simulation.process("b", work('b'), &clerk, Priority::high);
    CHECK(simulation.run().time == microseconds{20});
    CHECK(order == "aabb");
}

TEST_CASE("each operation costs what the executive states") {
    CHECK(spent_by([] { compute(Cycles{42}); }) == Spent{42});
    CHECK(spent_by([] { par([] {}, [] {}); }) == Spent{3, 4, 4});
    CHECK(spent_by([] { Timer().read(); }) == Spent{5});
    CHECK(spent_by([] { Timer().wait_after(0); }) == Spent{6});
    CHECK(spent_by([] { wait_until(Time{0}); }) == Spent{7});
    CHECK(spent_by([] { alt(after(Time{0}, [] {}), skip([] {})); }) == Spent{10 + 30 + 20, 8, 300 + 200 + 1000});
    Channel<int> c("c");
    CHECK(spent_by([&] { alt(on(c.in(), [](int) {}), skip([] {})); }) == Spent{10 + 15 + 20, 8, 200 + 200 + 1000});
    CHECK(spent_by([&] { alt(when(false, skip([] {})), skip([] {})); }) == Spent{10 + 15 + 20, 8, 200 + 200 + 1000});
}

TEST_CASE(
    "both ends of a soft channel pay, and the second to arrive also pays for the copy in words of the executive") {
    struct FiveBytes {
        char bytes[5];
    };
    Channel<FiveBytes> c("c");
    CHECK(spent_by([&] { par([&] { c.out().output({}); }, [&] { c.in().input(); }); }) ==
          Spent{3, 1, 1, 3 * 100, 4, 4});
}

TEST_CASE("an output of one byte or one word costs the same for the first and the second process, without a copy") {
    auto spent = [](auto message, bool input_first) {
        Channel<decltype(message)> c("c");
        auto outputs = [&] { c.out().output(message); };
        auto inputs = [&] { c.in().input(); };
        return input_first ? spent_by([&] { par(inputs, outputs); }) : spent_by([&] { par(outputs, inputs); });
    };
    CHECK(spent(std::int16_t{}, false) == Spent{3, 50, 1, 100, 4, 4});
    CHECK(spent(std::int16_t{}, true) == Spent{3, 1, 50, 4, 4});
    CHECK(spent(char{}, true) == Spent{3, 1, 50, 4, 4});
    CHECK(spent(std::int32_t{}, true) == Spent{3, 1, 1, 2 * 100, 4, 4}); // two words of this executive
}

TEST_CASE("a process reads the clock of its executive") {
    Time woken{};
    spent_by([&] { Timer().wait_after(2), woken = now(); });
    CHECK(woken == std::chrono::milliseconds{3});
}

TEST_CASE("a process on an executive communicates with a transputer over a link") {
    Simulation simulation;
    auto& clerk = simulation.add<Clerk>("clerk", costs_of_a_clerk);
    auto& t800 = simulation.add<Processor>("t800");
    Channel<int> there("there"), back("back");
    auto& link = simulation.add<Link>();
    there.put_on(link.from_a_to_b());
    back.put_on(link.from_b_to_a());
    int answer = 0;
    simulation.process(
        "asks", [&] { there.out().output(20), answer = back.in().input(); }, &clerk);
    simulation.process(
        "answers", [&] { back.out().output(there.in().input() + 1); }, &t800);
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(answer == 21);
    CHECK(clerk.spent() == Spent{2, 2});
}

TEST_CASE("a simulation with its own executive unwinds its processes when it ends stuck") {
    Simulation simulation;
    auto& clerk = simulation.add<Clerk>("clerk", costs_of_a_clerk);
    Channel<int> c("c");
    bool unwound = false;
    struct Note {
        bool& set;
        ~Note() { set = true; }
    };
    simulation.process(
        "waits",
        [&] {
            Note note{unwound};
            c.in().input();
        },
        &clerk);
    CHECK(simulation.run().ending == Ending::stuck);
    CHECK(unwound);
}
