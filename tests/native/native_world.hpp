#pragma once

#include "tests/runtime/small_world.hpp"

#include "native/crossing.hpp"
#include "native/group.hpp"
#include "runtime/alternation.hpp"
#include "runtime/simulation.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <deque>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace placedpar::test {

/// Runs a world on threads. A world has `channels`, which are SmallWorld::Ends, and for each of its `processes` a list
/// of actions without polls.
template <class World>
class NativeWorld {
public:
    /// `threads` has the thread of each process. REQUIRES: the world outlives this object.
    NativeWorld(const World& world, std::vector<std::size_t> threads)
        : world_(world), threads_(std::move(threads)), passed_(world.channels.size()) {
        for (std::size_t i = 0; i <= *std::ranges::max_element(threads_); ++i)
            group_.add(simulations_.emplace_back());
        for (const SmallWorld::Ends& ends : world.channels)
            lay(ends);
        for (std::size_t p = 0; p < threads_.size(); ++p)
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
    /// Returns the channels in the order in which their messages passed: a character for each, '0' for the first.
    const std::string& trace() const { return trace_; }

private:
    /// The ends of a channel. `input` is null if both processes are on one thread and share `output`.
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
    /// Records that message `number` has passed. The first of the two partners to continue calls this function, before
    /// it does anything else.
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
    const World& world_;
    std::vector<std::size_t> threads_;
    std::deque<Simulation> simulations_;
    native::Group group_;
    std::vector<Halves> channels_;
    std::list<native::Crossing> crossings_;
    std::vector<Passed> passed_;
    std::mutex mutex_;
    std::string trace_;
};

} // namespace placedpar::test
