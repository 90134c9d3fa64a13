// Every network of three processes and a few actions: the runtime does what CSP allows, and nothing else, wherever the
// processes are placed.

#include "tests/runtime/every_world.hpp"
#include "tests/sanitized.hpp"

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"

#include <doctest/doctest.h>

#include <array>
#include <list>
#include <memory>
#include <optional>

using namespace placedpar;
using namespace placedpar::test;

namespace {

struct Course {
    std::string trace; ///< the channels on which messages passed, in order
    bool completed;
};

enum class Placed {
    nowhere,
    together, ///< on one processor
    apart     ///< each on one of its own, each channel on a link
};

/// Runs the world, its ready queue in order or, with a seed, shuffled.
class WorldRun {
public:
    explicit WorldRun(const SmallWorld& world, Placed placed = Placed::nowhere)
        : world_(world), passed_(world.channels.size()) {
        for (std::size_t i = 0; i < world.channels.size(); ++i) {
            channels_.push_back(std::make_unique<Channel<int>>(std::string(1, static_cast<char>('0' + i))));
            if (placed == Placed::apart)
                channels_.back()->put_on(links_.emplace_back(kernel_).from_a_to_b());
        }
        if (placed != Placed::nowhere)
            for (hardware::Processor*& each : executives_)
                each = placed == Placed::together && !processors_.empty() ? &processors_.front()
                                                                          : &processors_.emplace_back(kernel_, "t");
    }
    Course run(std::optional<std::uint64_t> seed) {
        if (seed)
            kernel_.shuffle(*seed);
        for (std::size_t p = 0; p < 3; ++p) {
            processes_.emplace_back(
                kernel_, "p", [this, p] { act(p); }, executives_[p], Priority::low);
            kernel_.make_ready(processes_.back());
        }
        Ending ending = kernel_.run(Time::max(), {});
        return {trace_, ending == Ending::completed};
    }

private:
    void act(std::size_t process) {
        for (const Action& action : world_.processes[process])
            if (action.kind == Action::output)
                output(action.channel);
            else if (action.kind == Action::input)
                note(action.channel, channels_[action.channel]->in().input());
            else
                alternate(process, action.kind == Action::poll);
    }
    void output(std::size_t channel) {
        int number = ++passed_[channel].output;
        channels_[channel]->out().output(number);
        note(channel, number);
    }
    void alternate(std::size_t process, bool with_skip) {
        std::vector<Guard> guards;
        for (std::size_t i = 0; i < channels_.size(); ++i)
            guards.push_back(
                {world_.channels[i].inputter == process ? Guard::input : Guard::never, channels_[i].get()});
        if (with_skip)
            guards.push_back({Guard::skip});
        std::size_t chosen = select(guards);
        if (chosen < channels_.size())
            note(chosen, channels_[chosen]->in().input());
    }
    /// The first of the two partners to go on tells that message `number` has passed.
    void note(std::size_t channel, int number) {
        if (passed_[channel].noted == number)
            return;
        CHECK(++passed_[channel].noted == number);
        trace_ += static_cast<char>('0' + channel);
    }

    struct Passed {
        int output = 0, noted = 0;
    };
    const SmallWorld& world_;
    Kernel kernel_;
    std::list<hardware::Processor> processors_;
    std::list<hardware::Link> links_;
    std::array<hardware::Processor*, 3> executives_{};
    std::vector<std::unique_ptr<Channel<int>>> channels_;
    std::list<Process> processes_;
    std::vector<Passed> passed_;
    std::string trace_;
};

void check_course(const SmallWorld& world, Placed placed, std::optional<std::uint64_t> seed) {
    Course course = WorldRun(world, placed).run(seed);
    Interpreter interpreter(world);
    auto states = interpreter.start();
    for (char channel : course.trace)
        states = interpreter.after(states, static_cast<std::size_t>(channel - '0'));
    if (states.empty() || !interpreter.can_end(states, course.completed))
        FAIL("world ", world.text(), ", placed ", static_cast<int>(placed), ", did ", course.trace,
             course.completed ? " and completed" : " and got stuck");
}

int check_all(std::size_t channels, std::size_t longest, bool polls, Placed placed = Placed::nowhere) {
    int worlds = 0;
    for (const SmallWorld& network : every_network(channels))
        for_every_program(network, longest, polls, [&](const SmallWorld& world) {
            ++worlds;
            if (placed == Placed::nowhere) // executives share themselves out in their own order
                check_course(world, placed, std::nullopt);
            check_course(world, placed, worlds);
        });
    return worlds;
}

} // namespace

TEST_CASE("three processes, three channels, up to four actions each: the course is one that CSP allows") {
    for (Placed placed : {Placed::nowhere, Placed::together, Placed::apart})
        if (test::sanitized)
            CHECK(check_all(3, 3, false, placed) == 11053);
        else
            CHECK(check_all(3, 4, false, placed) == 66274);
}

TEST_CASE("two channels with polls, up to three actions") { CHECK(check_all(2, 3, true) == 5410); }

// Minutes: ctest -C studies -L studies
TEST_CASE("four channels, up to four actions, wherever they are placed" * doctest::skip()) {
    for (Placed placed : {Placed::nowhere, Placed::together, Placed::apart})
        CHECK(check_all(4, 4, false, placed) == 1567978);
}

TEST_CASE("worlds that no course tells apart are one, all others are there") {
    CHECK(every_network(1).size() == 1);
    CHECK(every_network(2).size() == 5);  // (21 + 9) / 6
    CHECK(every_network(3).size() == 10); // Burnside's lemma: (56 + 4) / 6
    std::set<std::string> worlds;
    for_every_program({{{0, 1}}, {}}, 2, false, [&](const SmallWorld& world) { worlds.insert(world.text()); });
    // Who waits for ever does not get to its second action.
    CHECK(worlds == std::set<std::string>{"0>1 | | | ", "0>1 | !0 | | ", "0>1 | | ?0 | ", "0>1 | !0 | ?0 | ",
                                          "0>1 | !0 !0 | ?0 | ", "0>1 | !0 | ?0 ?0 | ", "0>1 | !0 !0 | ?0 ?0 | "});
}

TEST_CASE("shuffled ready queues reach every trace that CSP allows two senders and an alternation") {
    SmallWorld world{{{0, 2}, {1, 2}},
                     {{{{Action::output, 0}, {Action::output, 0}},
                       {{Action::output, 1}},
                       {{Action::alternate}, {Action::alternate}, {Action::alternate}}}}};
    std::set<std::string> seen;
    for (std::uint64_t seed = 0; seed < 64; ++seed)
        seen.insert(WorldRun(world).run(seed).trace);
    CHECK(seen == std::set<std::string>{"001", "010", "100"});
    CHECK(seen == Interpreter(world).traces());
}
