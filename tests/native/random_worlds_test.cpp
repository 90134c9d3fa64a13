// Tests random networks of up to six processes with ALTs on 2, 3 and 5 threads, and the dining philosophers: each run
// takes a course that CSP allows, none hangs.

#include "tests/native/native_world.hpp"
#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"

#include "classics/kinds.hpp"
#include "native/native_run.hpp"
#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/read.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::test;

namespace {

/// A network of any number of processes.
struct RandomWorld {
    std::vector<SmallWorld::Ends> channels;
    std::vector<std::vector<Action>> processes;

    std::string text() const;
};

std::string RandomWorld::text() const {
    std::string out;
    for (const SmallWorld::Ends& ends : channels)
        out += fmt::format("{}>{} ", ends.outputter, ends.inputter);
    for (const auto& actions : processes) {
        out += "|";
        for (const Action& action : actions)
            out += fmt::format(" {}{}", "!?A"[action.kind], action.is_alternation() ? action.guards : action.channel);
        out += " ";
    }
    return out;
}

class WorldMaker {
public:
    explicit WorldMaker(std::uint64_t seed) : random_(seed) {}

    /// Makes a world in which some order of communications leads to its end. In every second world, two actions of a
    /// process are then exchanged, which often makes it stuck.
    RandomWorld make() {
        lay_channels();
        for (std::size_t steps = 3 + below(20); steps > 0; --steps)
            communicate(below(world_.channels.size()));
        if (below(2) == 0)
            disturb(world_.processes[below(world_.processes.size())]);
        return world_;
    }

private:
    std::size_t below(std::size_t limit) { return random_() % limit; }

    void lay_channels() {
        const std::size_t processes = 2 + below(5);
        world_.processes.resize(processes);
        for (std::size_t left = 1 + below(9); left > 0; --left) {
            const std::size_t from = below(processes), to = (from + 1 + below(processes - 1)) % processes;
            world_.channels.push_back({from, to});
        }
    }
    void communicate(std::size_t channel) {
        const auto [from, to] = world_.channels[channel];
        world_.processes[from].push_back({.kind = Action::output, .channel = channel});
        Action taking{.kind = Action::input, .channel = channel};
        if (below(3) > 0) {
            taking = {.kind = Action::alternate, .guards = std::uint32_t{1} << channel};
            for (std::size_t i = 0; i < world_.channels.size(); ++i)
                if (world_.channels[i].inputter == to && below(2) == 0)
                    taking.guards |= std::uint32_t{1} << i;
        }
        world_.processes[to].push_back(taking);
    }
    void disturb(std::vector<Action>& actions) {
        if (actions.size() > 1)
            std::swap(actions[below(actions.size())], actions[below(actions.size())]);
    }

    std::mt19937_64 random_;
    RandomWorld world_;
};

/// Follows a world without time. As no action is a poll, a communication has only one outcome.
class Course {
public:
    explicit Course(const RandomWorld& world) : world_(world), done_(world.processes.size()) {}

    /// Returns whether the channel's message can pass now, and lets it pass.
    bool passes(std::size_t channel) {
        if (!can_pass(channel))
            return false;
        ++done_[world_.channels[channel].outputter];
        ++done_[world_.channels[channel].inputter];
        return true;
    }
    /// Returns whether the world can end here as stated.
    bool ends(bool completed) const {
        bool all_over = true, stuck = true;
        for (std::size_t p = 0; p < done_.size(); ++p)
            all_over = all_over && !next(p);
        for (std::size_t channel = 0; channel < world_.channels.size(); ++channel)
            stuck = stuck && !can_pass(channel);
        return stuck && all_over == completed;
    }

private:
    const Action* next(std::size_t process) const {
        const auto& actions = world_.processes[process];
        return done_[process] < actions.size() ? &actions[done_[process]] : nullptr;
    }
    bool can_pass(std::size_t channel) const {
        const Action* const output = next(world_.channels[channel].outputter);
        const Action* const input = next(world_.channels[channel].inputter);
        return output && input && output->kind == Action::output && output->channel == channel && input->takes(channel);
    }

    const RandomWorld& world_;
    std::vector<std::size_t> done_;
};

/// Runs the world, and returns whether it completed.
bool check_on(const RandomWorld& world, std::size_t threads) {
    std::vector<std::size_t> thread_of;
    for (std::size_t p = 0; p < world.processes.size(); ++p)
        thread_of.push_back(p % threads);
    NativeWorld run(world, thread_of);
    const bool completed = run.run();
    Course course(world);
    CHECK_MESSAGE(std::ranges::all_of(run.trace(),
                                      [&](char each) { return course.passes(static_cast<std::size_t>(each - '0')); }),
                  world.text(), " on ", threads, " threads did ", run.trace());
    CHECK_MESSAGE(course.ends(completed), world.text(), " on ", threads, " threads ended after ", run.trace());
    return completed;
}

/// Returns how many cases to run: in a study PLACEDPAR_TIMES as many as in CI.
std::size_t cases(std::size_t in_ci) {
    const char* const times = std::getenv("PLACEDPAR_TIMES");
    return (times ? std::strtoull(times, nullptr, 10) : 1) * (sanitized ? in_ci / 10 : in_ci);
}

RunReport run_philosophers(std::size_t threads, bool butler) {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    add_classical_kinds(catalogue);
    const ReadResult read =
        read_netlist(std::string(PLACEDPAR_SOURCE_DIR) + "/examples/csp/philosophers/philosophers.cfs", catalogue,
                     {{"butler", butler ? "1" : "0"}, {"meals", "3"}});
    NativeSettings settings;
    settings.threads = threads;
    settings.make_catalogue = [&] { return std::shared_ptr<const Catalogue>(std::shared_ptr<void>(), &catalogue); };
    return run_natively(*read.network, settings);
}

/// Checks that each process of the cycle waits on a channel to the next one.
void check_cycle(const Deadlock& deadlock) {
    REQUIRE(deadlock.cycle.size() >= 2);
    for (std::size_t i = 0; i < deadlock.cycle.size(); ++i) {
        const std::string &self = deadlock.cycle[i], &next = deadlock.cycle[(i + 1) % deadlock.cycle.size()];
        CHECK_MESSAGE(std::ranges::any_of(deadlock.channels,
                                          [&](const StuckChannel& channel) {
                                              const bool outputs = channel.waiting == "outputter";
                                              return (outputs ? channel.outputter : channel.inputter) == self &&
                                                     (outputs ? channel.inputter : channel.outputter) == next;
                                          }),
                      self, " does not wait for ", next, ":\n", deadlock.text());
    }
}

} // namespace

TEST_CASE("random networks with ALTs take a course that CSP allows, on 2, 3 and 5 threads") {
    std::size_t completed = 0, stuck = 0;
    for (const std::uint64_t seed : seeds(cases(1500))) {
        INFO(replay(seed));
        const RandomWorld world = WorldMaker(seed).make();
        for (const std::size_t threads : {2U, 3U, 5U})
            ++(check_on(world, threads) ? completed : stuck);
    }
    if (all_seeds()) {
        CHECK(completed > cases(500));
        CHECK(stuck > cases(500));
    }
}

TEST_CASE("the philosophers end their meals with a butler, and without one in a true cycle or not at all") {
    for (std::size_t i = 0; i < cases(150); ++i)
        for (const std::size_t threads : {2U, 3U, 5U}) {
            CHECK(run_philosophers(threads, true).result.ending == Ending::completed);
            const RunResult result = run_philosophers(threads, false).result;
            CHECK((result.ending == Ending::completed) != result.deadlock.has_value());
            if (result.deadlock)
                check_cycle(*result.deadlock);
        }
}
