// Tests every network of three processes with a few actions each, on threads: the runtime does only what CSP allows.

#include "tests/runtime/every_world.hpp"

#include "native/crossing.hpp"
#include "native/group.hpp"
#include "runtime/alternation.hpp"
#include "runtime/simulation.hpp"

#include <doctest/doctest.h>

#include <array>
#include <deque>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

/// The thread of each process.
using Threads = std::array<std::size_t, 3>;
constexpr std::array<Threads, 4> all_threads{Threads{0, 1, 2}, Threads{0, 0, 1}, Threads{0, 1, 0}, Threads{0, 1, 1}};

class NativeWorld {
public:
    NativeWorld(const SmallWorld& world, const Threads& threads)
        : world_(world), threads_(threads), passed_(world.channels.size()) {
        for (std::size_t i = 0; i <= *std::ranges::max_element(threads); ++i)
            group_.add(simulations_.emplace_back());
        for (const SmallWorld::Ends& ends : world.channels)
            lay(ends);
        for (std::size_t p = 0; p < 3; ++p)
            simulations_[threads_[p]].process(std::to_string(p), [this, p] { act(p); });
    }

    /// Runs the world, and returns whether it completed.
    bool run() {
        std::vector<RunResult> results(simulations_.size());
        {
            std::vector<std::jthread> running;
            for (std::size_t i = 0; i < results.size(); ++i)
                running.emplace_back([&, i] { results[i] = simulations_[i].run(); });
        }
        return std::ranges::all_of(results, [](const auto& each) { return each.ending == Ending::completed; });
    }
    const std::string& trace() const { return trace_; }

private:
    /// The halves of a channel, which are one if both processes are on one thread.
    struct Halves {
        std::unique_ptr<Channel<int>> output, input;
    };

    void lay(const SmallWorld::Ends& ends) {
        Halves& halves = channels_.emplace_back();
        const std::string name = std::to_string(channels_.size() - 1);
        halves.output = std::make_unique<Channel<int>>(name);
        const std::size_t from = threads_[ends.outputter], to = threads_[ends.inputter];
        if (from == to)
            return;
        halves.input = std::make_unique<Channel<int>>(name);
        crossings_.emplace_back(*halves.output, group_.member(from), *halves.input, group_.member(to));
    }
    Channel<int>& input_of(std::size_t channel) {
        return channels_[channel].input ? *channels_[channel].input : *channels_[channel].output;
    }
    void act(std::size_t process) {
        for (const Action& action : world_.processes[process])
            if (action.kind == Action::output)
                output(action.channel);
            else if (action.kind == Action::input)
                note(action.channel, input_of(action.channel).in().input());
            else
                alternate(action);
    }
    void output(std::size_t channel) {
        const int number = ++passed_[channel].output;
        channels_[channel].output->out().output(number);
        note(channel, number);
    }
    void alternate(const Action& action) {
        std::vector<Guard> guards;
        for (std::size_t i = 0; i < channels_.size(); ++i)
            guards.push_back({action.is_guarded_by(i) ? Guard::input : Guard::never, &input_of(i)});
        const std::size_t chosen = select(guards);
        note(chosen, input_of(chosen).in().input());
    }
    /// Records that message `number` has passed. The first partner to continue does so, before it does anything else.
    void note(std::size_t channel, int number) {
        const std::lock_guard lock(mutex_);
        if (passed_[channel].noted == number)
            return;
        CHECK(++passed_[channel].noted == number);
        trace_ += static_cast<char>('0' + channel);
    }

    struct Passed {
        int output = 0, noted = 0;
    };
    const SmallWorld& world_;
    Threads threads_;
    std::deque<Simulation> simulations_;
    native::Group group_;
    std::vector<Halves> channels_;
    std::list<native::Crossing> crossings_;
    std::vector<Passed> passed_;
    std::mutex mutex_;
    std::string trace_;
};

void check_course(const SmallWorld& world, const Threads& threads) {
    NativeWorld run(world, threads);
    const bool completed = run.run();
    const Interpreter interpreter(world);
    auto states = interpreter.start();
    for (const char channel : run.trace())
        states = interpreter.after(states, static_cast<std::size_t>(channel - '0'));
    if (states.empty() || !interpreter.can_end(states, completed))
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
    CHECK(check_all({2}) == 1233);
    CHECK(check_all({.longest = 2, .any_guards = true}) > 1233);
}

TEST_CASE("all worlds of up to three actions take a course that CSP allows, on threads" * doctest::skip()) {
    CHECK(check_all({3}) == 65824);
}
