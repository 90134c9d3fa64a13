// Tests every network of three processes with a few actions each. In every placement the runtime does only what CSP
// allows.

#include "tests/runtime/every_world.hpp"
#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <list>
#include <memory>
#include <optional>

using namespace placedpar;
using namespace placedpar::test;

namespace {

struct Course {
    std::string trace; ///< channels on which messages passed, in order
    bool completed;
};

/// The processor of each process; nullopt if no process has a processor. Channels between processors have their own
/// links; other channels are soft.
using Placement = std::optional<std::array<unsigned, 3>>;

enum Where : std::size_t { nowhere, together, apart, in_pairs };

/// The placements. From in_pairs on, there is one placement for each pair of processes.
constexpr std::array<Placement, 6> placements{std::nullopt,           std::array{0u, 0u, 0u}, std::array{0u, 1u, 2u},
                                              std::array{0u, 0u, 1u}, std::array{0u, 1u, 0u}, std::array{0u, 1u, 1u}};

/// Runs the world with its ready queue in order, or shuffled by a seed.
class WorldRun {
public:
    explicit WorldRun(const SmallWorld& world, const Placement& placement = std::nullopt)
        : world_(world), passed_(world.channels.size()) {
        if (placement)
            place(*placement);
        for (const SmallWorld::Ends& ends : world.channels)
            lay(ends);
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
    void place(const std::array<unsigned, 3>& placement) {
        for (std::size_t i = 0; i < placement.size(); ++i) {
            while (processors_.size() <= placement[i])
                processors_.emplace_back(kernel_, "t");
            executives_[i] = &*std::next(processors_.begin(), placement[i]);
        }
    }
    void lay(const SmallWorld::Ends& ends) {
        channels_.push_back(std::make_unique<Channel<int>>(std::to_string(channels_.size())));
        if (executives_[ends.outputter] != executives_[ends.inputter])
            channels_.back()->put_on(links_.emplace_back(kernel_).from_a_to_b());
    }
    void act(std::size_t process) {
        for (const Action& action : world_.processes[process])
            if (action.kind == Action::output)
                output(action.channel);
            else if (action.kind == Action::input)
                note(action.channel, channels_[action.channel]->in().input());
            else
                alternate(action);
    }
    void output(std::size_t channel) {
        int number = ++passed_[channel].output;
        channels_[channel]->out().output(number);
        note(channel, number);
    }
    void alternate(const Action& action) {
        std::vector<Guard> guards;
        for (std::size_t i = 0; i < channels_.size(); ++i)
            guards.push_back({action.is_guarded_by(i) ? Guard::input : Guard::never, channels_[i].get()});
        if (action.kind == Action::poll)
            guards.push_back({Guard::skip});
        std::size_t chosen = select(guards);
        if (chosen < channels_.size())
            note(chosen, channels_[chosen]->in().input());
    }
    /// Records that message `number` has passed. The first partner to continue does so.
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

void check_course(const SmallWorld& world, std::size_t where, std::optional<std::uint64_t> seed) {
    Course course = WorldRun(world, placements[where]).run(seed);
    if (!Interpreter(world).allows(course.trace, course.completed))
        FAIL("placed ", where, " it did ", course.trace, course.completed ? " and completed" : " and got stuck",
             "; again: PLACEDPAR_WORLD='", world.text(), "' PLACEDPAR_SEED=", seed.value_or(0),
             " test_runtime -tc='the world that is asked for*'");
}

/// Checks all worlds and returns their number. Each world runs without processors and unshuffled, then in every
/// placement. Only one of the placements in pairs is used, in rotation. With `in_turns` the world runs in only two
/// placements, in rotation.
std::size_t check_all(const Bounds& bounds, bool in_turns = false) {
    std::size_t worlds = 0;
    for_every_world(bounds, [&](const SmallWorld& world) {
        check_course(world, nowhere, std::nullopt); // executives distribute processes in their own order
        const std::size_t turn = worlds++;
        if (in_turns)
            for (std::size_t where : {turn % 6, (turn + 3) % 6})
                check_course(world, where, turn);
        else
            for (std::size_t where : {+nowhere, +together, +apart, in_pairs + turn % 3})
                check_course(world, where, turn);
    });
    return worlds;
}

/// Finds the kinds of worlds independently. Generates all programs with the given number of channels for each pair of
/// processes, whether or not every action is reached.
class AllPrograms {
public:
    AllPrograms(std::size_t longest, std::size_t channels_alike) : longest_(longest) {
        for (std::size_t i = 0; i < 9 * channels_alike; ++i)
            if (i / 3 % 3 != i % 3)
                world_.channels.push_back({i / 3 % 3, i % 3});
    }
    std::set<std::string> kinds() {
        write(0);
        return std::move(kinds_);
    }

private:
    void write(std::size_t process) {
        if (process == 3)
            return note();
        write(process + 1);
        if (world_.processes[process].size() < longest_)
            for (const Action& action : alphabet(process)) {
                world_.processes[process].push_back(action);
                write(process);
                world_.processes[process].pop_back();
            }
    }
    std::vector<Action> alphabet(std::size_t process) const {
        std::vector<Action> actions{{Action::alternate}};
        for (std::size_t i = 0; i < world_.channels.size(); ++i)
            if (world_.channels[i].outputter == process)
                actions.push_back({Action::output, i});
            else if (world_.channels[i].inputter == process)
                actions.push_back({Action::input, i});
        return actions;
    }
    void note() {
        SmallWorld guarded = world_;
        for (std::size_t process = 0; process < 3; ++process)
            for (Action& action : guarded.processes[process])
                if (action.kind == Action::alternate && (action.guards = channels_used_to(process)) == 0)
                    return;
        if (comes_to_all(guarded))
            kinds_.insert(text_of_its_kind(guarded));
    }
    std::uint32_t channels_used_to(std::size_t process) const {
        std::uint32_t used = 0;
        for (const auto& actions : world_.processes)
            for (const Action& action : actions)
                if (!action.is_alternation() && world_.channels[action.channel].inputter == process)
                    used |= std::uint32_t{1} << action.channel;
        return used;
    }
    static bool comes_to_all(const SmallWorld& world) {
        Interpreter::State furthest{};
        for (const Interpreter::State& state : Interpreter(world).reachable())
            for (std::size_t process = 0; process < 3; ++process)
                furthest[process] = std::max(furthest[process], state[process]);
        for (std::size_t process = 0; process < 3; ++process)
            if (furthest[process] + 1u < world.processes[process].size())
                return false;
        return true;
    }

    std::size_t longest_;
    SmallWorld world_;
    std::set<std::string> kinds_;
};

/// Returns the greatest number of channels from one process to another.
std::size_t most_channels_alike(const SmallWorld& world) {
    std::array<std::size_t, 9> alike{};
    for (const SmallWorld::Ends& ends : world.channels)
        ++alike[3 * ends.outputter + ends.inputter];
    return *std::ranges::max_element(alike);
}

} // namespace

TEST_CASE("every world of up to three actions a process takes a course that CSP allows") {
    if (test::sanitized)
        CHECK(check_all({2}) == 1233);
    else
        CHECK(check_all({3}, true) == 65824);
}

TEST_CASE(
    "every world of up to two actions with polls and alternations on any channels takes a course that CSP allows") {
    if (!test::sanitized)
        CHECK(check_all({.longest = 2, .polls = true, .any_guards = true}) == 6503);
}

// This takes half an hour: ctest -C studies -L studies
TEST_CASE("all worlds of up to four actions take a course that CSP allows, in every placement" * doctest::skip()) {
    CHECK(check_all({4}) == 4258915);
}

TEST_CASE("all worlds of up to three actions with polls or alternations on any channels take a course that CSP allows" *
          doctest::skip()) {
    CHECK(check_all({.longest = 3, .polls = true}) == 406867);
    CHECK(check_all({.longest = 3, .any_guards = true}) == 564472);
}

TEST_CASE("the world in PLACEDPAR_WORLD takes a course that CSP allows, in every placement" *
          doctest::skip(std::getenv("PLACEDPAR_WORLD") == nullptr)) {
    SmallWorld world = SmallWorld::of(std::getenv("PLACEDPAR_WORLD"));
    for (std::size_t where = nowhere; where < placements.size(); ++where) {
        check_course(world, where, std::nullopt);
        for (std::uint64_t seed : test::seeds(100))
            check_course(world, where, seed);
    }
}

TEST_CASE("a world is rebuilt from its text") {
    for_every_world({.longest = 2, .polls = true}, [](const SmallWorld& world) {
        if (std::string text = world.text(); SmallWorld::of(text).text() != text)
            FAIL(text);
    });
    CHECK_THROWS_AS(SmallWorld::of("0>1 | X0 | ?0 |"), std::invalid_argument);
}

TEST_CASE("the generated worlds are all worlds, each once") {
    for (auto [longest, channels_alike] : {std::pair(1u, 2u), std::pair(2u, 1u)}) {
        std::size_t worlds = 0;
        std::set<std::string> kinds;
        for_every_world({longest}, [&, most = channels_alike](const SmallWorld& world) {
            if (most_channels_alike(world) <= most)
                ++worlds, kinds.insert(text_of_its_kind(world));
        });
        CHECK(kinds.size() == worlds);
        CHECK(kinds == AllPrograms(longest, channels_alike).kinds());
    }
}

TEST_CASE("worlds in which a process waits for ever have no second action of this process") {
    std::set<std::string> worlds;
    for_every_world({2}, [&](const SmallWorld& world) {
        if (world.channels.size() == 1)
            worlds.insert(text_of_its_kind(world));
    });
    CHECK(worlds.size() == 14);
    CHECK(!worlds.contains(text_of_its_kind({{{0, 1}}, {{{{Action::output, 0}, {Action::output, 0}}, {}, {}}}})));
}

TEST_CASE("shuffled ready queues reach every trace that CSP allows two senders and an alternation") {
    SmallWorld world{{{0, 2}, {1, 2}},
                     {{{{Action::output, 0}, {Action::output, 0}},
                       {{Action::output, 1}},
                       {{Action::alternate, 0, 3}, {Action::alternate, 0, 3}, {Action::alternate, 0, 3}}}}};
    std::set<std::string> seen;
    for (std::uint64_t seed = 0; seed < 64; ++seed)
        seen.insert(WorldRun(world).run(seed).trace);
    CHECK(seen == std::set<std::string>{"001", "010", "100"});
    CHECK(seen == Interpreter(world).traces());
}
