// Tests channels in packets on machines with faults.

#include "runtime/hardware/router.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/hardware/routed_machine.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;
using std::chrono::milliseconds;
using test::Graph;
using test::hypercube;
using test::line;
using test::ring;
using test::RoutedMachine;
using test::torus;

namespace {

using Way = std::vector<std::size_t>;

struct PostedLetter {
    std::size_t number, bytes;
    WireForm wire_form() const { return WireForm(bytes); }
};

/// A machine in which each processor sends letters to some others, along random routes.
class Post {
public:
    static constexpr std::size_t letters = 3;

    Post(const Graph& graph, std::uint64_t seed) : machine(graph), random_(seed, "post") {
        for (std::size_t from = 0; from < graph.nodes; ++from)
            for (std::size_t there = 0; there < graph.nodes; ++there)
                if (there != from && random_.below(2) == 0)
                    add_sender(from, there);
    }

    /// Checks at the end of the run which channels have stopped. The processes still exist then.
    template <class IsStopped>
    RunResult run(IsStopped is_stopped) {
        return machine.simulation.run(Time::max(), [this, is_stopped] {
            for (const Route* route : routes)
                stopped.push_back(is_stopped(*route));
        });
    }
    RunResult run() {
        return run([](const Route&) { return false; });
    }

    bool leads_over(std::size_t channel, std::pair<std::size_t, std::size_t> link) const {
        const Way& way = ways[channel];
        for (std::size_t i = 0; i + 1 < way.size(); ++i)
            if (std::pair(way[i], way[i + 1]) == link || std::pair(way[i + 1], way[i]) == link)
                return true;
        return false;
    }
    bool leads_by(std::size_t channel, std::size_t processor) const {
        return std::ranges::find(ways[channel], processor) != ways[channel].end();
    }

    RoutedMachine machine;
    // These members are indexed by channel.
    std::vector<Way> ways;
    std::vector<const Route*> routes;
    std::vector<std::size_t> sent; ///< number of letters
    std::vector<bool> stopped;     ///< state at the end of the run
    std::vector<std::vector<std::size_t>> received;

private:
    void add_sender(std::size_t from, std::size_t there) {
        std::size_t channel = ways.size();
        ways.push_back(machine.random_way(from, there, random_));
        Route& route = machine.route(ways.back());
        routes.push_back(&route);
        sent.push_back(0);
        received.emplace_back();
        Channel<PostedLetter>& c = channels_.emplace_back("c" + std::to_string(channel));
        c.put_on(route);
        add_taker(there, c.in(), channel);
        std::vector<PostedLetter> all;
        for (std::size_t i = 0; i < letters; ++i)
            all.push_back({random_.below(1000), random_.below(3) == 0 ? 700u : 1u + random_.below(40)});
        machine.simulation.process(
            "s" + std::to_string(channel), {c.out()},
            [&c, all, channel, this] {
                for (const PostedLetter& letter : all) {
                    c.out().output(letter);
                    ++sent[channel];
                }
            },
            machine.processors[from]);
    }

    /// Adds one receiver for each channel. A common receiver would block on a message of which only a part arrives.
    void add_taker(std::size_t there, Input<PostedLetter> from, std::size_t channel) {
        machine.simulation.process(
            "t" + std::to_string(channel), {from},
            [from, channel, this] {
                for (std::size_t n = 0; n < letters; ++n)
                    received[channel].push_back(from.input().number);
            },
            machine.processors[there]);
    }

    std::list<Channel<PostedLetter>> channels_;
    RandomStream random_;
};

bool begins_with(const std::vector<std::size_t>& whole, const std::vector<std::size_t>& part) {
    return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}

Time moment_in(Time duration, RandomStream& random) {
    return Time{static_cast<std::int64_t>(random.uniform() * static_cast<double>(duration.count()))};
}

std::vector<Graph> graphs() { return {line(4), ring(5), torus(3, 3), hypercube(3)}; }

bool is_named(const RunResult& result, const std::string& process) {
    return result.deadlock && std::ranges::find(result.deadlock->processes, process, &StuckProcess::path) !=
                                  result.deadlock->processes.end();
}

} // namespace

TEST_CASE("a slow link under routers only delays messages, which all arrive in order") {
    for (const Graph& graph : graphs())
        for (std::uint64_t seed : test::seeds(4, 1)) {
            CAPTURE(graph.nodes);
            INFO(test::replay(seed));
            Post sound(graph, seed), struck(graph, seed);
            RunResult without = sound.run();
            RandomStream random(seed, "fault");
            std::size_t link = random.below(static_cast<std::uint32_t>(graph.links.size()));
            Time from = moment_in(without.time, random);
            const FaultEffect& effect =
                struck.machine.links[link]->suffer({.kind = LinkFault::Kind::slow,
                                                    .from = from,
                                                    .until = later(from, Time{1} + moment_in(without.time, random)),
                                                    .factor = 2 + random.below(30)});
            CHECK(struck.run().ending == Ending::completed);
            CHECK(struck.received == sound.received);
            CHECK(effect.bytes_lost + effect.acknowledges_lost == 0);
        }
}

TEST_CASE("if a link under routers loses a packet, the channels with packets there stop and all others continue") {
    std::size_t stuck = 0;
    for (const Graph& graph : graphs())
        for (std::uint64_t seed : test::seeds(12, 1)) {
            CAPTURE(graph.nodes);
            INFO(test::replay(seed));
            Post sound(graph, seed), struck(graph, seed);
            RunResult without = sound.run();
            REQUIRE(without.ending == Ending::completed);
            RandomStream random(seed, "fault");
            std::size_t link = random.below(static_cast<std::uint32_t>(graph.links.size()));
            bool silent = random.below(2) == 0;
            Time from = moment_in(without.time, random);
            Time until =
                random.below(2) == 0 ? Time::max() : later(from, Time{1} + moment_in(microseconds{50}, random));
            bool both = random.below(2) == 0, from_a = random.below(2) == 0;
            const FaultEffect& effect = struck.machine.links[link]->suffer(
                {.kind = silent ? LinkFault::Kind::silent : LinkFault::Kind::loses_acknowledge,
                 .from = from,
                 .until = silent ? until : Time::max(),
                 .wire_from_a = both || from_a,
                 .wire_from_b = both || !from_a});
            RunResult result =
                struck.run([&](const Route& route) { return route.is_stopped_at(*struck.machine.shared[link]); });
            std::size_t stopped = 0;
            for (std::size_t channel = 0; channel < struck.ways.size(); ++channel) {
                CAPTURE(channel);
                bool complete = struck.sent[channel] == Post::letters;
                CHECK(begins_with(sound.received[channel], struck.received[channel]));
                CHECK(struck.received[channel].size() >= struck.sent[channel]);
                CHECK(struck.received[channel].size() <= struck.sent[channel] + 1);
                if (!struck.leads_over(channel, graph.links[link]))
                    CHECK(complete);
                CHECK(complete != struck.stopped[channel]);
                CHECK(complete != is_named(result, "s" + std::to_string(channel)));
                stopped += !complete;
            }
            CHECK((result.ending == Ending::stuck) == (stopped > 0));
            // each direction stops at its first loss
            CHECK(effect.bytes_lost + effect.acknowledges_lost <= (silent ? 2 : 1));
            CHECK((effect.last.has_value() || stopped == 0));
            if (effect.last)
                CHECK(effect.last->message != FaultEffect::Hit::Message::whole);
            stuck += stopped > 0;
        }
    if (test::all_seeds())
        CHECK(stuck > 15);
}

TEST_CASE("a processor that halts stops the channels that lead over it, and no others") {
    std::size_t stuck = 0;
    for (const Graph& graph : graphs())
        for (std::uint64_t seed : test::seeds(8, 1)) {
            CAPTURE(graph.nodes);
            INFO(test::replay(seed));
            Post sound(graph, seed), struck(graph, seed);
            RunResult without = sound.run();
            RandomStream random(seed, "fault");
            std::size_t halted = random.below(static_cast<std::uint32_t>(graph.nodes));
            Time from = moment_in(without.time, random);
            struck.machine.processors[halted]->halt_at(from);
            for (std::size_t i = 0; i < graph.links.size(); ++i)
                if (graph.links[i].first == halted || graph.links[i].second == halted)
                    struck.machine.links[i]->suffer({.from = from,
                                                     .wire_from_a = graph.links[i].first == halted,
                                                     .wire_from_b = graph.links[i].second == halted});
            RunResult result =
                struck.run([&](const Route& route) { return route.is_stopped_by(*struck.machine.processors[halted]); });
            for (std::size_t channel = 0; channel < struck.ways.size(); ++channel) {
                CAPTURE(channel);
                CHECK(begins_with(sound.received[channel], struck.received[channel]));
                bool complete = struck.sent[channel] == Post::letters;
                if (!struck.leads_by(channel, halted))
                    CHECK(complete);
                CHECK(complete != is_named(result, "s" + std::to_string(channel)));
                if (!complete && struck.ways[channel].front() != halted)
                    CHECK(struck.stopped[channel]);
            }
            stuck += result.ending == Ending::stuck;
        }
    if (test::all_seeds())
        CHECK(stuck > 15);
}

TEST_CASE("a lost packet is reported for its channel, whose processes are in a deadlock although others continue") {
    RoutedMachine machine(line(3));
    Channel<int> lost("lost", machine.route({0, 1, 2})), other("other", machine.route({0, 1}));
    machine.simulation.process(
        "outputs", {lost.out()}, [&] { lost.out().output(1); }, machine.processors[0]);
    machine.simulation.process(
        "inputs", {lost.in()}, [&] { lost.in().input(); }, machine.processors[2]);
    machine.simulation.process(
        "ticks", {other.out()},
        [&] {
            for (;;)
                other.out().output(1), wait_for(milliseconds{1});
        },
        machine.processors[0]);
    machine.simulation.process(
        "tocks", {other.in()},
        [&] {
            for (;;)
                other.in().input();
        },
        machine.processors[1]);
    const FaultEffect& effect = machine.links[1]->suffer({});
    RunResult result = machine.simulation.run(milliseconds{20});
    CHECK(result.ending == Ending::time_limit);
    REQUIRE(effect.first);
    CHECK(effect.first->channel == "lost");
    CHECK(effect.first->message == FaultEffect::Hit::Message::packet);
    CHECK(effect.first->byte == 1);
    REQUIRE(result.deadlock);
    REQUIRE(result.deadlock->processes.size() == 2);
    CHECK(result.deadlock->processes[0].path == "outputs");
    CHECK(result.deadlock->processes[1].path == "inputs");
}
