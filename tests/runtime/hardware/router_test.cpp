// Tests channels that share a link, and channels that are routed over other processors.

#include "runtime/alternation.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/router.hpp"
#include "runtime/parallel.hpp"
#include "runtime/random.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/cycle.hpp"
#include "tests/runtime/hardware/routed_machine.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <list>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;
using std::chrono::nanoseconds;
using test::cycle;
using test::Graph;
using test::hypercube;
using test::line;
using test::ring;
using test::RoutedMachine;
using test::torus;

namespace {

struct TwoNodes {
    Simulation simulation;
    Processor& a = simulation.add<Processor>("a");
    Processor& b = simulation.add<Processor>("b");
    Link& link = simulation.add<Link>();
    RouterLink& shared = simulation.add<RouterLink>(link, simulation.add<Router>(&a), simulation.add<Router>(&b));

    Carrier& carrier(bool forth) { return simulation.add<Route>(std::vector{Hop{shared, forth}}); }
};

} // namespace

TEST_CASE("two channels each way over one link deliver every message in the order of its channel") {
    TwoNodes nodes;
    std::list<Channel<int>> channels;
    std::array<std::vector<int>, 4> received;
    for (std::size_t i = 0; i < 4; ++i) {
        bool forth = i < 2;
        Channel<int>& c = channels.emplace_back("c");
        c.put_on(nodes.carrier(forth));
        nodes.simulation.process(
            "outputter",
            [&c, i] {
                for (int k = 0; k < 20; ++k)
                    c.out().output(static_cast<int>(100 * i) + k);
            },
            forth ? &nodes.a : &nodes.b);
        nodes.simulation.process(
            "inputter",
            [&c, &received, i] {
                for (int k = 0; k < 20; ++k)
                    received[i].push_back(c.in().input());
            },
            forth ? &nodes.b : &nodes.a);
    }
    CHECK(nodes.simulation.run().ending == Ending::completed);
    for (std::size_t i = 0; i < 4; ++i) {
        REQUIRE(received[i].size() == 20);
        for (int k = 0; k < 20; ++k)
            CHECK(received[i][static_cast<std::size_t>(k)] == static_cast<int>(100 * i) + k);
    }
}

TEST_CASE(
    "an outputter continues only after its message was input, and a late inputter does not stop another channel") {
    TwoNodes nodes;
    Channel<int> late("late", nodes.carrier(true)), prompt("prompt", nodes.carrier(true));
    Time late_output{}, late_input{}, prompt_output{};
    nodes.simulation.process(
        "outputs late", [&] { late.out().output(1), late_output = now(); }, &nodes.a);
    nodes.simulation.process(
        "outputs prompt", [&] { prompt.out().output(1), prompt_output = now(); }, &nodes.a);
    nodes.simulation.process(
        "inputs late", [&] { wait_until(microseconds{1000}), late.in().input(), late_input = now(); }, &nodes.b);
    nodes.simulation.process(
        "inputs prompt", [&] { prompt.in().input(); }, &nodes.b);
    CHECK(nodes.simulation.run().ending == Ending::completed);
    CHECK(late_input >= microseconds{1000});
    CHECK(late_output > late_input);
    CHECK(prompt_output < microseconds{200});
}

TEST_CASE("a message over routers costs one packet each way on the link and two handlings on each processor") {
    TwoNodes nodes;
    Channel<std::array<char, 100>> c("c", nodes.carrier(true));
    Time output{}, input{};
    nodes.simulation.process(
        "outputs", [&] { c.out().output({}), output = now(); }, &nodes.a);
    nodes.simulation.process(
        "inputs", [&] { c.in().input(), input = now(); }, &nodes.b);
    CHECK(nodes.simulation.run().ending == Ending::completed);
    CHECK(nodes.link.from_a_to_b().bytes_carried() == RouterPacket::header_bytes + 100);
    CHECK(nodes.link.from_b_to_a().bytes_carried() == RouterPacket::header_bytes);
    // On a, the sender handles the packet and outputs it (200 + 19 cycles). The receiver inputs the acknowledge and
    // handles it (19 + 200). The program outputs (19), and the receiver inputs a second packet (19). The sender's start
    // interrupts the program at most once.
    for (const Processor* processor : {&nodes.a, &nodes.b}) {
        Time least = (2 * 200 + 4 * 19) * cycle;
        CHECK(processor->time_busy() >= least);
        CHECK(processor->time_busy() <= least + 2 * 19 * cycle);
    }
    Time on_link = 103 * nanoseconds{560} + nanoseconds{550};
    // The inputting process has low priority, so b handles the acknowledge packet first.
    CHECK(input >= on_link + 3 * 200 * cycle);
    CHECK(input <= on_link + (3 * 200 + 6 * 19) * cycle);
    Time back_on_link = 3 * nanoseconds{560} + nanoseconds{550};
    CHECK(output - input >= back_on_link + 200 * cycle);
    CHECK(output - input <= back_on_link + (200 + 3 * 19) * cycle);
}

TEST_CASE("an idle router does not keep a run from completing") {
    TwoNodes nodes;
    Channel<int> c("c", nodes.carrier(true));
    nodes.simulation.process(
        "computes", [] { compute(Cycles{10}); }, &nodes.a);
    CHECK(nodes.simulation.run().ending == Ending::completed);
}

namespace {

struct Text {
    std::size_t number, bytes;
    WireForm wire_form() const { return WireForm(bytes); }
};

/// Lets every processor send short and long messages to every other processor. Returns the messages that arrived on
/// each channel, in order. If `machine` is null, no process is placed.
std::vector<std::vector<std::size_t>> all_talk_to_all(std::size_t nodes, std::uint64_t seed, RoutedMachine* machine) {
    constexpr std::size_t messages = 2;
    Simulation unplaced;
    Simulation& simulation = machine ? machine->simulation : unplaced;
    RandomStream random(seed, "messages"), ways(seed, "ways");
    std::list<Channel<Text>> channels;
    std::vector<std::vector<Channel<Text>*>> to(nodes);
    std::vector<std::vector<std::size_t>> received(nodes * nodes);
    for (std::size_t from = 0; from < nodes; ++from)
        for (std::size_t there = 0; there < nodes; ++there)
            if (there != from) {
                Channel<Text>& c = channels.emplace_back("c");
                if (machine)
                    c.put_on(machine->route(machine->random_way(from, there, ways)));
                std::vector<Text> texts;
                for (std::size_t i = 0; i < messages; ++i)
                    texts.push_back({random.below(1000), random.below(6) == 0 ? 600u : 1u + random.below(40)});
                to[there].push_back(&c);
                simulation.process(
                    "sends",
                    [&c, texts] {
                        for (const Text& text : texts)
                            c.out().output(text);
                    },
                    machine ? machine->processors[from] : nullptr);
            }
    for (std::size_t there = 0; there < nodes; ++there)
        simulation.process(
            "takes",
            [&, there] {
                std::vector<Input<Text>> inputs;
                for (Channel<Text>* c : to[there])
                    inputs.push_back(c->in());
                for (std::size_t n = 0; n < messages * inputs.size(); ++n)
                    alt(std::span<const Input<Text>>(inputs),
                        [&](std::size_t i, const Text& text) { received[there * nodes + i].push_back(text.number); });
            },
            machine ? machine->processors[there] : nullptr);
    CHECK(simulation.run().ending == Ending::completed);
    return received;
}

} // namespace

TEST_CASE("a transfer over two links takes the sum of its parts, to the picosecond") {
    RoutedMachine machine(line(3));
    Channel<std::array<char, 10>> c("c", machine.route({0, 1, 2}));
    Time begin{}, input{}, output{};
    machine.simulation.process(
        "outputs",
        [&] {
            wait_until(microseconds{100});
            begin = now();
            c.out().output({});
            output = now();
        },
        machine.processors[0]);
    machine.simulation.process(
        "inputs", [&] { c.in().input(), input = now(); }, machine.processors[2]);
    CHECK(machine.simulation.run().ending == Ending::completed);

    constexpr auto handling = 200 * cycle, instruction = 19 * cycle;
    auto on_link = [](int bytes) { return (bytes - 1) * nanoseconds{560} + nanoseconds{550}; };
    // The message is output. The sender handles its packet and outputs it.
    Time there = instruction + handling + instruction + on_link(14);
    // The receiver handles the packet and inputs the next one. The sender handles the packet and outputs it.
    constexpr Time passed_on = 2 * (handling + instruction);
    there += passed_on + on_link(14);
    // At the destination, the acknowledge leaves before the inputting process continues, which has low priority.
    there += passed_on;
    CHECK(input - begin == there);
    Time back = on_link(4) + passed_on + on_link(4) + handling + instruction;
    CHECK(output - input == back);
    CHECK(machine.routers[1]->packets_passed_on() == 2);
    CHECK(machine.routers[1]->cycles_of_passing_on() == Cycles{2 * 2 * (200 + 19)});
    CHECK(machine.routers[0]->packets_passed_on() == 0);
    CHECK(machine.links[0]->from_a_to_b().bytes_carried() == 14);
    CHECK(machine.links[1]->from_a_to_b().bytes_carried() == 14);
    CHECK(machine.links[0]->from_b_to_a().bytes_carried() == 4);
}

TEST_CASE("packets passed on slow down a processor's computation by their cost alone") {
    auto end_of_computing = [](int messages) {
        RoutedMachine machine(line(3));
        Channel<std::array<char, 100>> c("c", machine.route({0, 1, 2}));
        Time end{};
        machine.simulation.process(
            "outputs",
            [&] {
                wait_until(microseconds{100});
                for (int i = 0; i < messages; ++i)
                    c.out().output({});
            },
            machine.processors[0]);
        machine.simulation.process(
            "computes", [&] { compute(Cycles{200'000}), end = now(); }, machine.processors[1]);
        machine.simulation.process(
            "inputs",
            [&] {
                for (int i = 0; i < messages; ++i)
                    c.in().input();
            },
            machine.processors[2]);
        CHECK(machine.simulation.run().ending == Ending::completed);
        return end;
    };
    // Each message has a packet and an acknowledge packet. Each of these is received and sent, and interrupts when it
    // arrives and when it has gone.
    Time each = 2 * (2 * 19 + 2 * (200 + 19)) * cycle;
    CHECK(end_of_computing(1) - end_of_computing(0) == each);
    CHECK(end_of_computing(7) - end_of_computing(0) == 7 * each);
}

TEST_CASE("a short message overtakes a long one on every link that they share") {
    RoutedMachine machine(line(3));
    Channel<Text> long_one("long", machine.route({0, 1, 2})), short_one("short", machine.route({0, 1, 2}));
    Time long_done{}, short_sent{}, short_done{};
    machine.simulation.process(
        "outputs long",
        [&] {
            long_one.out().output({1, 100'000}), long_done = now();
        },
        machine.processors[0]);
    machine.simulation.process(
        "outputs short",
        [&] {
            wait_until(microseconds{10'000});
            short_sent = now();
            short_one.out().output({2, 10}), short_done = now();
        },
        machine.processors[0]);
    machine.simulation.process(
        "inputs long", [&] { CHECK(long_one.in().input().number == 1); }, machine.processors[2]);
    machine.simulation.process(
        "inputs short", [&] { CHECK(short_one.in().input().number == 2); }, machine.processors[2]);
    CHECK(machine.simulation.run().ending == Ending::completed);
    CHECK(long_done > microseconds{56'000}); // 100000 bytes at 1786 bytes a millisecond
    // On each link the short message waits for one packet of the other channel. In the opposite direction there are
    // only acknowledges.
    Time packet = 260 * nanoseconds{560};
    CHECK(short_done - short_sent > microseconds{100});
    CHECK(short_done - short_sent < 2 * 2 * packet + microseconds{150});
    CHECK(machine.links[0]->from_a_to_b().bytes_carried() == 100'000 + 391 * 4 + 14);
}

TEST_CASE("a long message over three links is nearly as fast as over one, because its packets follow each other") {
    auto time_over = [](std::size_t links) {
        RoutedMachine machine(line(links + 1));
        Channel<Text> c("c");
        std::vector<std::size_t> way(links + 1);
        std::iota(way.begin(), way.end(), std::size_t{0});
        c.put_on(machine.route(way));
        machine.simulation.process(
            "outputs",
            [&] {
                c.out().output({1, 100'000});
            },
            machine.processors.front());
        machine.simulation.process(
            "inputs", [&] { c.in().input(); }, machine.processors.back());
        RunResult result = machine.simulation.run();
        CHECK(result.ending == Ending::completed);
        return result.time;
    };
    CHECK(time_over(3) > time_over(1));
    CHECK(time_over(3) < time_over(1) * 12 / 10);
}

TEST_CASE("if all processors send to all others at once, on any routes, all messages arrive and nothing is stuck") {
    for (const Graph& graph : {line(4), ring(3), ring(6), torus(3, 3), hypercube(2), hypercube(3)})
        for (std::uint64_t seed : test::seeds(2, 1)) {
            CAPTURE(graph.nodes);
            CAPTURE(graph.links.size());
            INFO(test::replay(seed));
            RoutedMachine machine(graph);
            CHECK(all_talk_to_all(graph.nodes, seed, &machine) == all_talk_to_all(graph.nodes, seed, nullptr));
        }
}

TEST_CASE("hundreds of channels on a torus of 256 processors and a hypercube of 64 deliver all messages") {
    for (auto [graph, channels] : {std::pair(torus(16, 16), 300), std::pair(hypercube(6), 300)}) {
        RoutedMachine machine(graph);
        RandomStream random(1, "channels");
        std::list<Channel<Text>> all;
        std::size_t received = 0, bytes = 0, packets_passed_on = 0;
        for (int i = 0; i < channels; ++i) {
            auto nodes = static_cast<std::uint32_t>(graph.nodes);
            std::size_t from = random.below(nodes), to = (from + 1 + random.below(nodes - 1)) % nodes;
            std::vector<std::size_t> way = machine.shortest_way(from, to);
            Channel<Text>& c = all.emplace_back("c");
            c.put_on(machine.route(way));
            Text text{random.below(1000), 1 + random.below(600)};
            std::size_t packets = (text.bytes + 255) / 256;
            bytes += (way.size() - 1) * (text.bytes + 2 * packets * RouterPacket::header_bytes); // including
                                                                                                 // acknowledges
            packets_passed_on += (way.size() - 2) * 2 * packets;
            machine.simulation.process(
                "sends", [&c, text] { c.out().output(text); }, machine.processors[from]);
            machine.simulation.process(
                "takes", [&c, &received, text] { received += c.in().input().number == text.number; },
                machine.processors[to]);
        }
        CHECK(machine.simulation.run().ending == Ending::completed);
        CHECK(received == static_cast<std::size_t>(channels));
        std::size_t carried = 0, passed_on = 0;
        for (const Link* link : machine.links)
            carried += link->from_a_to_b().bytes_carried() + link->from_b_to_a().bytes_carried();
        for (const Router* router : machine.routers)
            passed_on += router->packets_passed_on();
        CHECK(carried == bytes);
        CHECK(passed_on == packets_passed_on);
    }
}

namespace {

/// A machine with a channel from each processor to every other, along a shortest path.
class AllToAll {
public:
    explicit AllToAll(const Graph& graph) : machine_(graph), nodes_(graph.nodes), channels_(graph.nodes) {
        for (std::size_t from = 0; from < nodes_; ++from)
            for (std::size_t further = 1; further < nodes_; ++further)
                add(from, further);
    }

    /// Lets each processor output to the next and input from the previous one, then do so at distance two, and so on.
    RunResult run() {
        for (std::size_t i = 0; i < nodes_; ++i)
            machine_.simulation.process(
                "p",
                [this, i] {
                    for (std::size_t further = 1; further < nodes_; ++further)
                        exchange(i, further);
                },
                machine_.processors[i]);
        return machine_.simulation.run();
    }

    std::size_t hops = 0, received = 0;

    std::size_t packets_passed_on() const {
        return std::accumulate(machine_.routers.begin(), machine_.routers.end(), std::size_t{0},
                               [](std::size_t sum, const Router* router) { return sum + router->packets_passed_on(); });
    }

private:
    void add(std::size_t from, std::size_t further) {
        auto way = machine_.shortest_way(from, (from + further) % nodes_);
        hops += way.size() - 1;
        channels_[from].emplace_back("c").put_on(machine_.route(way));
    }
    void exchange(std::size_t i, std::size_t further) {
        std::size_t before = (i + nodes_ - further) % nodes_;
        par(
            [&] {
                channels_[i][further - 1].out().output({i, 100});
            },
            [&] { received += channels_[before][further - 1].in().input().number == before; });
    }

    RoutedMachine machine_;
    std::size_t nodes_;
    std::vector<std::deque<Channel<Text>>> channels_; ///< by sender
};

void check_all_to_all(const Graph& graph) {
    AllToAll all(graph);
    CHECK(all.run().ending == Ending::completed);
    std::size_t messages = graph.nodes * (graph.nodes - 1);
    CHECK(all.received == messages);
    CHECK(all.packets_passed_on() == 2 * (all.hops - messages)); // including acknowledges
}

} // namespace

TEST_CASE("each of 36 processors of a torus outputs to all others, over the processors between") {
    check_all_to_all(torus(6, 6));
}

// This takes a minute: ctest -C studies -L studies
TEST_CASE("each of 256 processors of a torus outputs to all others" * doctest::skip()) {
    check_all_to_all(torus(16, 16));
}

TEST_CASE("routers add no buffers: processes that would wait for each other without routers still do") {
    RoutedMachine machine(ring(5));
    std::list<Channel<int>> channels;
    for (std::size_t i = 0; i < 5; ++i)
        channels.emplace_back("c" + std::to_string(i)).put_on(machine.route({i, (i + 1) % 5, (i + 2) % 5}));
    std::vector<Channel<int>*> at;
    for (Channel<int>& c : channels)
        at.push_back(&c);
    for (std::size_t i = 0; i < 5; ++i)
        machine.simulation.process(
            "p" + std::to_string(i), {at[i]->out(), at[(i + 3) % 5]->in()},
            [&, i] {
                at[i]->out().output(1);
                at[(i + 3) % 5]->in().input();
            },
            machine.processors[i]);
    RunResult result = machine.simulation.run();
    REQUIRE(result.ending == Ending::stuck);
    CHECK(result.deadlock->cycle == std::vector<std::string>{"p0", "p2", "p4", "p1", "p3"});
}

TEST_CASE("an alternation sees a message that waits at the end of its route") {
    RoutedMachine machine(line(3));
    Channel<int> far("far", machine.route({0, 1, 2})), near("near", machine.route({1, 2}));
    std::vector<int> taken;
    machine.simulation.process(
        "far", [&] { far.out().output(1); }, machine.processors[0]);
    machine.simulation.process(
        "near", [&] { wait_until(microseconds{500}), near.out().output(2); }, machine.processors[1]);
    machine.simulation.process(
        "takes",
        [&] {
            wait_until(microseconds{300});
            for (int i = 0; i < 2; ++i)
                alt(on(far.in(), [&](int x) { taken.push_back(x); }),
                    on(near.in(), [&](int x) { taken.push_back(x); }));
        },
        machine.processors[2]);
    CHECK(machine.simulation.run().ending == Ending::completed);
    CHECK(taken == std::vector<int>{1, 2});
}
