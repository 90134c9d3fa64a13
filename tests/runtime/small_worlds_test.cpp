// Every network of three processes and a few actions: the runtime does what CSP allows, and nothing else, wherever the
// processes are placed.

#include "small_world.hpp"

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"

#include <doctest/doctest.h>

#include <array>
#include <functional>
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

std::vector<Action> alphabet(const SmallWorld& world, std::size_t process, bool polls) {
    std::vector<Action> actions;
    std::size_t inputs = 0;
    for (std::size_t i = 0; i < world.channels.size(); ++i) {
        if (world.channels[i].outputter == process)
            actions.push_back({Action::output, i});
        if (world.channels[i].inputter == process)
            actions.push_back({Action::input, i}), ++inputs;
    }
    if (inputs > 1)
        actions.push_back({Action::alternate});
    if (inputs > 0 && polls)
        actions.push_back({Action::poll});
    return actions;
}

/// Gives every process every sequence of at most `longest` actions, and hands the worlds to `check`.
void for_every_program(SmallWorld& world, std::size_t process, std::size_t longest, bool polls,
                       const std::function<void()>& check) {
    if (process == 3)
        return check();
    for_every_program(world, process + 1, longest, polls, check);
    if (world.processes[process].size() == longest)
        return;
    for (const Action& action : alphabet(world, process, polls)) {
        world.processes[process].push_back(action);
        for_every_program(world, process, longest, polls, check);
        world.processes[process].pop_back();
    }
}

/// Every way to lay channels between three processes, the first from 0 to 1: the others are the same with
/// other names for processes.
void for_every_network(std::size_t channels, const std::function<void(SmallWorld&)>& check) {
    std::vector<SmallWorld::Ends> all;
    for (std::size_t from = 0; from < 3; ++from)
        for (std::size_t to = 0; to < 3; ++to)
            if (from != to)
                all.push_back({from, to});
    SmallWorld world{{{0, 1}}, {}};
    for (std::size_t i = 0; i < all.size(); ++i) {
        world.channels.resize(1);
        world.channels.push_back(all[i]);
        if (channels == 2)
            check(world);
        else
            for (std::size_t k = i; k < all.size(); ++k) {
                world.channels.resize(2);
                world.channels.push_back(all[k]);
                check(world);
            }
    }
}

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
    for_every_network(channels, [&](SmallWorld& world) {
        for_every_program(world, 0, longest, polls, [&] {
            ++worlds;
            if (placed == Placed::nowhere) // executives share themselves out in their own order
                check_course(world, placed, std::nullopt);
            check_course(world, placed, worlds);
        });
    });
    return worlds;
}

/// One of those that are too many to try all: three channels anywhere, four actions each.
SmallWorld larger_world(RandomStream& random) {
    SmallWorld world;
    for (int i = 0; i < 3; ++i) {
        std::size_t from = random.below(3);
        world.channels.push_back({from, (from + 1 + random.below(2)) % 3});
    }
    for (std::size_t process = 0; process < 3; ++process)
        if (auto actions = alphabet(world, process, false); !actions.empty())
            for (int i = 0; i < 4; ++i)
                world.processes[process].push_back(actions[random.below(static_cast<std::uint32_t>(actions.size()))]);
    return world;
}

} // namespace

TEST_CASE("three processes, two channels, up to four actions each: the course is one that CSP allows") {
    CHECK(check_all(2, 4, false) == 10062);
}

TEST_CASE("the same on one processor, and on three with a link for each channel") {
    CHECK(check_all(2, 4, false, Placed::together) == 10062);
    CHECK(check_all(2, 4, false, Placed::apart) == 10062);
}

TEST_CASE("three processes, three channels, four actions each: some of the worlds, wherever they are placed") {
    RandomStream random(1, "larger worlds");
    for (int i = 0; i < 2000; ++i) {
        SmallWorld world = larger_world(random);
        for (Placed placed : {Placed::nowhere, Placed::together, Placed::apart})
            check_course(world, placed, i);
    }
}

TEST_CASE("two channels with polls, up to two actions") { CHECK(check_all(2, 2, true) == 1394); }

TEST_CASE("three processes, three channels, up to two actions each") { CHECK(check_all(3, 2, false) == 9007); }

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
