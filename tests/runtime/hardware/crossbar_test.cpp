// Tests a crossbar switch that is set while links pass through it.

#include "runtime/hardware/crossbar.hpp"

#include "runtime/channel.hpp"
#include "runtime/hardware/link.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/switched_lane.hpp"
#include "runtime/parallel.hpp"
#include "runtime/random.hpp"
#include "runtime/recovery.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <array>
#include <bitset>
#include <deque>
#include <functional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using namespace std::chrono_literals;
using Kind = SwitchCommand::Kind;

namespace {

struct Parcel {
    std::uint32_t bytes = 1;
    int number = 0;
    WireForm wire_form() const { return WireForm(bytes); }
};

/// Obeys commands as the logic of the switch on which it is placed.
void obey(Input<SwitchCommand> commands, Output<SwitchAnswer> answers, int count) {
    for (int i = 0; i < count; ++i)
        if (auto answer = Crossbar::here().obey(commands.input()))
            answers.output(*answer);
}

/// A processor whose link 0 leads through a switch to two partners: through the switch's links 0 and 1 to a, and
/// through links 0 and 2 to b.
struct Exchange {
    Simulation simulation;
    Crossbar& sw = simulation.add<Crossbar>("sw");
    std::array<Link*, 2> links{&simulation.add<Link>(LinkTiming{}, "root.link[0]", "a.link[0]"),
                               &simulation.add<Link>(LinkTiming{}, "root.link[0]", "b.link[0]")};
    SharedEngine out{"root.link[0]"}, in{"root.link[0]"}, at_a{"a.link[0]"}, at_b{"b.link[0]"};
    SwitchedLane& to_a = simulation.add<SwitchedLane>(links[0]->from_a_to_b(), out, at_a);
    SwitchedLane& to_b = simulation.add<SwitchedLane>(links[1]->from_a_to_b(), out, at_b);
    Channel<Parcel> a{"root.out[0] -> a.in"}, b{"root.out[1] -> b.in"};

    Exchange() {
        sw.lead_on(*links[0], 0, 1);
        sw.lead_on(*links[1], 0, 2);
        a.put_on(to_a);
        b.put_on(to_b);
    }
    void set(int partner) {
        sw.obey({Kind::connect_links, 0, static_cast<std::uint8_t>(1 + partner)});
        sw.obey({Kind::ready});
    }
    /// Sends 1000 bytes to a, which is connected at the start. `change` takes effect after 100 us, when 179 bytes have
    /// begun, one every 560 ns.
    RunResult change_in_message(std::function<void()> change) {
        set(0);
        simulation.process("root", [this] { a.out().output({1000, 1}); });
        simulation.process("a", [this] { a.in().input(); });
        simulation.process("setter", [change = std::move(change)] {
            wait_until(100us);
            change();
        });
        return simulation.run();
    }
    static constexpr Time last_byte_before_the_change = 179 * 560ns;
};

} // namespace

TEST_CASE("each command has the effect of its contract, and an enquiry returns the input of an output") {
    Simulation simulation;
    Crossbar& sw = simulation.add<Crossbar>("sw");
    auto answer = [&](std::uint8_t output) { return static_cast<int>(sw.obey({Kind::enquire, output})->byte); };
    CHECK(answer(7) == 0);
    CHECK(!sw.obey({Kind::connect_output, 3, 7}));
    CHECK(answer(7) == (0x80 | 3));
    CHECK(answer(3) == 0);
    CHECK(!sw.leads(3, 7)); // only after command 3
    CHECK(!sw.obey({Kind::ready}));
    CHECK(sw.leads(3, 7));
    CHECK(!sw.leads(7, 3));
    sw.obey({Kind::connect_output, 3, 8}); // one input to two outputs
    sw.obey({Kind::connect_links, 0, 31});
    CHECK(sw.leads(3, 7)); // unchanged
    sw.obey({Kind::ready});
    CHECK(sw.leads(3, 8));
    CHECK(sw.leads(0, 31));
    CHECK(sw.leads(31, 0));
    CHECK(answer(0) == (0x80 | 31));
    CHECK(answer(31) == 0x80);
    sw.obey({Kind::disconnect_output, 7});
    CHECK(!sw.leads(3, 7));
    CHECK(sw.leads(3, 8));
    sw.obey({Kind::disconnect_links, 31, 0});
    CHECK(!sw.leads(0, 31));
    CHECK(!sw.leads(31, 0));
    sw.obey({Kind::reset});
    CHECK(!sw.leads(3, 8));
    CHECK(sw.connections() == 4);
    CHECK_THROWS_WITH_AS(sw.obey({Kind::connect_output, 3, 32}), "the switch sw has no link 32: its links are 0 to 31",
                         std::invalid_argument);
    CHECK_THROWS_AS(sw.obey({static_cast<Kind>(7)}), std::invalid_argument);
}

TEST_CASE("random commands give the connections that a table of the outputs gives") {
    RandomStream random(1, "commands");
    Simulation simulation;
    Crossbar& sw = simulation.add<Crossbar>("sw");
    std::array<int, 32> chosen;
    std::bitset<32> ready;
    chosen.fill(-1);
    auto choose = [&](std::size_t output, int input) {
        if (chosen[output] != input)
            ready.reset(output);
        chosen[output] = input;
    };
    for (int i = 0; i < 600; ++i) {
        auto kind = static_cast<Kind>(i % 100 == 99 ? 4 : random.below(7) == 6 ? 6 : random.below(4));
        auto first = static_cast<std::uint8_t>(random.below(32)), second = static_cast<std::uint8_t>(random.below(32));
        auto answer = sw.obey({kind, first, second});
        REQUIRE(answer.has_value() == (kind == Kind::enquire));
        if (kind == Kind::connect_output || kind == Kind::connect_links)
            choose(second, first);
        if (kind == Kind::connect_links)
            choose(first, second);
        if (kind == Kind::disconnect_links)
            chosen[first] = chosen[second] = -1;
        if (kind == Kind::reset)
            chosen.fill(-1);
        if (kind == Kind::ready)
            ready.set();
        if (answer)
            REQUIRE(answer->byte == (chosen[first] < 0 ? 0 : 0x80 | chosen[first]));
        for (std::size_t output = 0; output < 32; ++output)
            for (int input = 0; input < 32; ++input)
                REQUIRE(sw.leads(input, static_cast<int>(output)) == (ready[output] && chosen[output] == input));
    }
}

TEST_CASE("commands take the time of their bytes on the configuration link, and act when their last byte has arrived") {
    Simulation simulation;
    Crossbar& sw = simulation.add<Crossbar>("sw");
    Processor& root = simulation.add<Processor>("root");
    Link& config = simulation.add<Link>();
    Channel<SwitchCommand> commands("commands");
    Channel<SwitchAnswer> answers("answers");
    commands.put_on(config.from_a_to_b());
    answers.put_on(config.from_b_to_a());
    simulation.process(
        "logic", [&] { obey(commands.in(), answers.out(), 3); }, &sw);
    Time sent{}, answered{};
    int answer = 0;
    simulation.process(
        "setter",
        [&] {
            commands.out().output({Kind::connect_links, 4, 5});
            sent = now();
            commands.out().output({Kind::ready});
            commands.out().output({Kind::enquire, 5});
            answer = answers.in().input().byte;
            answered = now();
        },
        &root);
    CHECK(simulation.run().ending == Ending::completed);
    CHECK(answer == (0x80 | 4));
    // 19 cycles, then two bytes of 11.2 bits and the third up to the end of its acknowledge
    CHECK(sent == 950ns + 2 * 560ns + 260ns + 100ns);
    // The answer takes this time for one byte, then for two bytes. It has arrived when its input begins, except for 19
    // cycles.
    CHECK(answered == sent + (950ns + 360ns) + (950ns + 560ns + 360ns) + 950ns);
}

TEST_CASE("a switched link carries each message to the partner that is connected") {
    Exchange x;
    Processor& root = x.simulation.add<Processor>("root");
    std::vector<int> came_to_a, came_to_b;
    x.simulation.process(
        "root",
        [&] {
            for (int i = 0; i < 6; ++i) {
                x.set(i % 2);
                (i % 2 == 0 ? x.a : x.b).out().output({100, i});
            }
        },
        &root);
    auto take = [](Channel<Parcel>& from, std::vector<int>& to) {
        for (int i = 0; i < 3; ++i)
            to.push_back(from.in().input().number);
    };
    x.simulation.process("a", [&] { take(x.a, came_to_a); });
    x.simulation.process("b", [&] { take(x.b, came_to_b); });
    CHECK(x.simulation.run().ending == Ending::completed);
    CHECK(came_to_a == std::vector{0, 2, 4});
    CHECK(came_to_b == std::vector{1, 3, 5});
    CHECK(x.sw.losses().empty());
    CHECK(x.links[0]->from_a_to_b().bytes_carried() == 300);
}

TEST_CASE("a message without a connection is lost in a deadlock, and the switch names the output") {
    struct Case {
        std::vector<SwitchCommand> commands;
        int output;
        bool acknowledge;
        const char* state;
    };
    for (const Case& each : std::vector<Case>{
             {{}, 1, false, "was connected to no input"},
             {{{Kind::connect_links, 0, 2}, {Kind::ready}}, 1, false, "was connected to no input"},
             {{{Kind::connect_links, 1, 2}, {Kind::ready}}, 1, false, "was connected to input 2"},
             {{{Kind::connect_links, 0, 1}}, 1, false, "was connected to input 0, but had not received command 3"},
             {{{Kind::connect_output, 0, 1}, {Kind::ready}}, 0, true, "was connected to no input"},
             {{{Kind::connect_links, 0, 1}, {Kind::ready}, {Kind::reset}}, 1, false, "was connected to no input"}}) {
        CAPTURE(each.state);
        Exchange x;
        for (const SwitchCommand& command : each.commands)
            x.sw.obey(command);
        x.simulation.process("root", {DeclaredEnd(x.a.out())}, [&] { x.a.out().output({2, 1}); });
        x.simulation.process("a", {DeclaredEnd(x.a.in())}, [&] { x.a.in().input(); });
        RunResult result = x.simulation.run();
        CHECK(result.ending == Ending::stuck);
        CHECK(result.deadlock->cycle == std::vector<std::string>{"root", "a"});
        REQUIRE(x.sw.losses().size() == 1);
        const Crossbar::Loss loss = x.sw.losses()[0];
        CHECK(loss.link == x.links[0]);
        CHECK(loss.leaves_a != each.acknowledge);
        CHECK(loss.output == each.output);
        CHECK(loss.state == each.state);
        CHECK(loss.effect.bytes_lost == (each.acknowledge ? 0 : 1));
        CHECK(loss.effect.acknowledges_lost == (each.acknowledge ? 1 : 0));
        CHECK(loss.effect.first->channel == "root.out[0] -> a.in");
        CHECK(loss.effect.first->byte == 1);
    }
}

TEST_CASE("losses in both directions are reported for each direction, with its own output") {
    Exchange x;
    SharedEngine out_of_a{"a.link[0]"};
    SwitchedLane& from_a = x.simulation.add<SwitchedLane>(x.links[0]->from_b_to_a(), out_of_a, x.in);
    Channel<Parcel> back("a.out -> root.in", from_a);
    x.simulation.process("root", [&] { par([&] { x.a.out().output({2, 1}); }, [&] { back.in().input(); }); });
    x.simulation.process("a", [&] { par([&] { back.out().output({3, 1}); }, [&] { x.a.in().input(); }); });
    CHECK(x.simulation.run().ending == Ending::stuck);
    auto losses = x.sw.losses();
    REQUIRE(losses.size() == 2);
    CHECK(losses[0].leaves_a);
    CHECK(losses[0].output == 1);
    CHECK(losses[0].effect.first->channel == "root.out[0] -> a.in");
    CHECK(!losses[1].leaves_a);
    CHECK(losses[1].output == 0);
    CHECK(losses[1].effect.first->channel == "a.out -> root.in");
    for (const Crossbar::Loss& loss : losses)
        CHECK(loss.effect.bytes_lost == 1);
}

TEST_CASE("a connection that changes within a message cuts it, and the loss names the byte") {
    for (bool every_byte : {false, true}) {
        Exchange x;
        if (every_byte)
            x.links[0]->from_a_to_b().simulate_every_byte();
        RunResult result = x.change_in_message([&] { x.sw.obey({Kind::disconnect_links, 0, 1}); });
        CHECK(result.ending == Ending::stuck);
        REQUIRE(x.sw.losses().size() == 1);
        FaultEffect lost = x.sw.losses()[0].effect;
        CHECK(lost.first->at == Exchange::last_byte_before_the_change);
        CHECK(lost.first->byte == 180);
        CHECK(!lost.first->acknowledge);
        CHECK(lost.bytes_lost == 1);
    }
}

TEST_CASE("the output to a partner continues to repeat its input when another output chooses the same input") {
    Exchange x;
    CHECK(x.change_in_message([&] { x.set(1); }).ending == Ending::stuck);
    REQUIRE(x.sw.losses().size() == 1);
    FaultEffect lost = x.sw.losses()[0].effect;
    CHECK(lost.first->at == Exchange::last_byte_before_the_change + 260ns);
    CHECK(lost.first->acknowledge);
    CHECK(x.sw.losses()[0].state == "was connected to input 2");
}

TEST_CASE("a connection that is restored before the next byte cuts nothing") {
    Exchange x;
    RunResult result = x.change_in_message([&] {
        x.sw.obey({Kind::reset});
        x.set(0);
    });
    CHECK(result.ending == Ending::completed);
    CHECK(x.sw.losses().empty());
}

TEST_CASE("one engine cannot be in two messages at a time") {
    Exchange x;
    x.simulation.process("root", [&] { par([&] { x.a.out().output({10, 1}); }, [&] { x.b.out().output({10, 1}); }); });
    CHECK_THROWS_WITH_AS(x.simulation.run(),
                         "channels root.out[0] -> a.in and root.out[1] -> b.in use root.link[0] at the same time: a "
                         "switch connects a link to only one partner at a time",
                         std::logic_error);
}

TEST_CASE("Crossbar::here() is refused for a process that is not on a switch") {
    Simulation simulation;
    simulation.process("p", [] { Crossbar::here(); });
    CHECK_THROWS_WITH_AS(simulation.run(), "process p is not on a crossbar switch", std::logic_error);
}

namespace {

/// Sends messages of random lengths to both partners. Messages that take too long are given up. The switch is set at
/// random times.
struct RandomWorld : Exchange {
    RandomWorld(std::uint64_t seed, bool every_byte) : random(seed, "switching") {
        for (Link* link : links)
            if (every_byte)
                link->from_a_to_b().simulate_every_byte(), link->from_b_to_a().simulate_every_byte();
        simulation.process("root", [this] { send(); });
        simulation.process("a", [this] { receive(a, 0); });
        simulation.process("b", [this] { receive(b, 1); });
        simulation.process("setter", [this] { switch_about(); });
    }

    void send() {
        RandomStream lengths(random(), "lengths");
        for (int i = 0; i < 30; ++i) {
            auto& to = lengths.chance(0.5) ? a : b;
            if (!output_or_fail(to.out(), Parcel{1 + lengths.below(300), i}, later(now(), Time{200us})))
                reset(to.out());
            wait_until(later(now(), Time{450us})); // both ends have given up by this time
        }
    }

    void receive(Channel<Parcel>& from, std::size_t whose) {
        while (now() < 25ms) {
            Parcel parcel;
            if (input_or_fail(from.in(), parcel, later(now(), Time{170us})))
                received.push_back({now(), parcel.number, whose});
            else
                pieces += reset(from.in());
        }
    }

    void switch_about() {
        RandomStream moments(random(), "moments");
        while (now() < 20ms) {
            wait_until(later(now(), std::chrono::nanoseconds{moments.below(120'000)}));
            switch (moments.below(4)) {
            case 0: set(0); break;
            case 1: set(1); break;
            case 2: sw.obey({Kind::connect_output, 0, static_cast<std::uint8_t>(1 + moments.below(2))}); break;
            default: sw.obey({Kind::ready});
            }
        }
    }

    RandomStream random;
    std::vector<std::tuple<Time, int, std::size_t>> received;
    std::uint64_t pieces = 0;
};

} // namespace

TEST_CASE("a switch set within messages at random has the same effect in the closed form as with every byte") {
    std::size_t received = 0, lost = 0;
    for (std::uint64_t seed : test::seeds(60)) {
        INFO(test::replay(seed));
        RandomWorld events(seed, true), closed(seed, false);
        RunResult by_events = events.simulation.run(), by_form = closed.simulation.run();
        CHECK(by_events.ending == by_form.ending);
        CHECK(by_events.time == by_form.time);
        CHECK(by_events.fingerprint == by_form.fingerprint);
        CHECK(events.received == closed.received);
        CHECK(events.pieces == closed.pieces);
        auto a = events.sw.losses(), b = closed.sw.losses();
        REQUIRE(a.size() == b.size());
        for (std::size_t i = 0; i < a.size(); ++i) {
            CHECK(a[i].effect.first->at == b[i].effect.first->at);
            CHECK(a[i].effect.last->byte == b[i].effect.last->byte);
            CHECK(a[i].effect.bytes_lost == b[i].effect.bytes_lost);
            CHECK(a[i].effect.acknowledges_lost == b[i].effect.acknowledges_lost);
            CHECK(a[i].state == b[i].state);
            lost += a[i].effect.bytes_lost;
        }
        received += closed.received.size();
    }
    if (test::all_seeds()) {
        CHECK(received > 300);
        CHECK(lost > 50);
    }
}
