// Tests faults of links at adapters, and messages given up there.

#include "runtime/channel.hpp"
#include "runtime/hardware/link_adapter.hpp"
#include "runtime/random.hpp"
#include "runtime/recovery.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/hardware/adapter_host.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;
using std::chrono::milliseconds;
using test::Host;
using test::Octets;

namespace {

/// Messages of random lengths in both directions through an adapter, with the messages that their receivers got.
struct BothWays {
    explicit BothWays(std::uint64_t seed) {
        RandomStream random(seed, "messages");
        down.put_on(host.driver.to_link());
        up.put_on(host.driver.from_link());
        for (auto [c, from, to, got] :
             {std::tuple(&down, static_cast<Executive*>(&host.sun), static_cast<Executive*>(&host.t800), &came_down),
              std::tuple(&up, static_cast<Executive*>(&host.t800), static_cast<Executive*>(&host.sun), &came_up)}) {
            std::vector<Octets> messages;
            for (std::uint8_t n = 0; n < 5; ++n)
                messages.emplace_back(random.below(60), n);
            host.simulation.process(
                c->name() + " out", {c->out()},
                [c = c, messages] {
                    for (const Octets& each : messages)
                        c->out().output(each);
                },
                from);
            host.simulation.process(
                c->name() + " in", {c->in()},
                [c = c, got = got] {
                    for (int n = 0; n < 5; ++n)
                        got->push_back(c->in().input());
                },
                to);
        }
    }

    Host host;
    Channel<Octets> down{"down"}, up{"up"};
    std::vector<Octets> came_down, came_up;
};

bool is_beginning(const std::vector<Octets>& whole, const std::vector<Octets>& part) {
    return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}

LinkFault random_fault(Time duration, RandomStream& random) {
    auto moment = [&] {
        return Time{static_cast<std::int64_t>(random.uniform() * static_cast<double>(duration.count()))};
    };
    using Kind = LinkFault::Kind;
    LinkFault fault{.kind = std::array{Kind::silent, Kind::loses_acknowledge, Kind::slow}[random.below(3)],
                    .from = moment()};
    if (fault.kind != Kind::loses_acknowledge && random.below(2) == 0)
        fault.until = later(later(fault.from, Time{1}), moment());
    fault.wire_from_a = fault.kind == Kind::slow || random.below(2) == 0;
    fault.wire_from_b = fault.kind == Kind::slow || !fault.wire_from_a || random.below(2) == 0;
    fault.factor = fault.kind == Kind::slow ? 1 + random.below(100) : 1;
    return fault;
}

} // namespace

TEST_CASE("at an adapter a slow link only delays messages, and a lost packet ends in a reported deadlock") {
    std::size_t stuck = 0;
    for (std::uint64_t seed : test::seeds(100, 1)) {
        INFO(test::replay(seed));
        BothWays sound(seed), struck(seed);
        RunResult without = sound.host.simulation.run();
        REQUIRE(without.ending == Ending::completed);
        RandomStream random(seed, "fault");
        LinkFault fault = random_fault(without.time, random);
        const FaultEffect& effect = struck.host.link.suffer(fault);
        RunResult result = struck.host.simulation.run();
        CHECK(is_beginning(sound.came_down, struck.came_down));
        CHECK(is_beginning(sound.came_up, struck.came_up));
        bool all = struck.came_down.size() + struck.came_up.size() == 10;
        if (fault.kind == LinkFault::Kind::slow)
            CHECK(result.ending == Ending::completed);
        CHECK((all || effect.last.has_value()));
        CHECK(effect.bytes_lost + effect.acknowledges_lost <= (fault.kind == LinkFault::Kind::silent ? 2 : 1));
        if (effect.first) {
            CHECK((effect.first->channel == "down" || effect.first->channel == "up"));
            CHECK(effect.first->byte >= 1);
            CHECK(effect.first->byte <= 4 + 60);
        }
        if (result.ending == Ending::completed)
            CHECK(all);
        else
            CHECK(result.ending == Ending::stuck);
        stuck += result.ending == Ending::stuck;
    }
    if (test::all_seeds())
        CHECK(stuck > 20);
}

TEST_CASE("messages at an adapter can be given up at either end, and later messages arrive") {
    struct Numbered {
        int number;
        char bytes[12];
    };
    constexpr int count = 40;
    std::size_t lost_some = 0;
    for (bool down : {true, false})
        for (std::uint64_t seed : test::seeds(60, 1)) {
            CAPTURE(down);
            INFO(test::replay(seed));
            Host host(1 + static_cast<std::int64_t>(seed % 40)); // number of unsuccessful polls before the program
                                                                 // sleeps
            RandomStream random(seed, "fault");
            LinkFault fault = random_fault(milliseconds{3}, random);
            host.link.suffer(fault);
            Channel<Numbered> c("c", down ? host.driver.to_link() : host.driver.from_link());
            std::vector<int> gone, came;
            auto patience = [&random] { return microseconds{300 + random.below(900)}; };
            host.simulation.process(
                "outputs",
                [&] {
                    for (int n = 0; n < count; ++n)
                        if (output_or_fail(c.out(), Numbered{n, {}}, later(now(), patience())))
                            gone.push_back(n);
                        else
                            CHECK(reset(c.out()) <= sizeof(Numbered));
                },
                down ? static_cast<Executive*>(&host.sun) : &host.t800);
            host.simulation.process(
                "inputs",
                [&] {
                    Numbered message{-1, {}};
                    for (int in_vain = 0; in_vain < 60 && message.number < count - 1;)
                        if (input_or_fail(c.in(), message, later(now(), patience()))) {
                            came.push_back(message.number);
                            in_vain = 0;
                        } else {
                            CHECK(reset(c.in()) <= sizeof(Numbered));
                            ++in_vain;
                        }
                },
                down ? static_cast<Executive*>(&host.t800) : &host.sun);
            CHECK(host.simulation.run().ending == Ending::completed);
            CHECK(std::is_sorted(came.begin(), came.end()));
            CHECK(std::adjacent_find(came.begin(), came.end()) == came.end());
            CHECK(std::includes(came.begin(), came.end(), gone.begin(), gone.end()));
            if (fault.kind == LinkFault::Kind::loses_acknowledge)
                CHECK(came.size() >= count / 2);
            lost_some += came.size() < count;
        }
    if (test::all_seeds())
        CHECK(lost_some > 30);
}

TEST_CASE("a message to an adapter that is given up while its acknowledge waits does not affect the next message") {
    for (Time given_up = microseconds{500}; given_up < microseconds{1500}; given_up += microseconds{20}) {
        CAPTURE(given_up.count());
        Host host(32,
                  LinkTiming{.bits_per_second = 10'000}); // slow: a byte is still arriving when the program has read it
        Channel<std::uint8_t> c("c", host.driver.from_link());
        Channel<Octets> other_way("other way", host.driver.to_link()); // acknowledges wait for bytes of this channel
        std::uint8_t message = 0;
        host.simulation.process(
            "sender",
            [&] {
                if (!output_or_fail(c.out(), std::uint8_t{1}, given_up))
                    reset(c.out());
                wait_until(Time{milliseconds{15}}); // the receiver is reset as well by this time
                c.out().output(2);
            },
            &host.t800);
        host.simulation.process(
            "receiver",
            [&] {
                for (int attempt = 0; attempt < 3 && message != 2; ++attempt)
                    if (!input_or_fail(c.in(), message, later(now(), milliseconds{10})))
                        reset(c.in());
            },
            &host.sun);
        host.simulation.process(
            "sender the other way", [&] { other_way.out().output(Octets(20)); }, &host.sun);
        host.simulation.process(
            "receiver the other way", [&] { other_way.in().input(); }, &host.t800);
        host.simulation.run();
        CHECK(message == 2);
    }
}

// At 10 kbit/s without overlap, an acknowledge begins 16.2 bits after its byte. The next byte begins 5.6 bits and 120
// ns later.
TEST_CASE(
    "an adapter whose message is given up while its register restarts writes no byte before the restart is over") {
    for (Time given_up = microseconds{1640}; given_up < microseconds{2180}; given_up += microseconds{20}) {
        CAPTURE(given_up.count());
        Host host(32, LinkTiming{.bits_per_second = 10'000, .overlapped_acknowledge = false});
        Channel<std::uint8_t> c("c", host.driver.to_link());
        std::vector<Time> arrived;
        host.simulation.process(
            "sender",
            [&] {
                if (!output_or_fail(c.out(), std::uint8_t{1}, given_up))
                    reset(c.out());
                c.out().output(2);
            },
            &host.sun);
        host.simulation.process(
            "receiver",
            [&] {
                for (int number : {1, 2}) {
                    CHECK(c.in().input() == number);
                    arrived.push_back(now());
                }
            },
            &host.t800);
        CHECK(host.simulation.run().ending == Ending::completed);
        REQUIRE(arrived.size() == 2);
        CHECK(arrived[1] - arrived[0] >= std::chrono::nanoseconds{2'180'120});
    }
}

TEST_CASE("a broadcast message cannot be given up") {
    Host host;
    auto& all = host.simulation.add<AdapterBroadcast>(std::vector{&host.driver});
    Channel<int> c("c");
    all.carry(c, 0);
    host.simulation.process(
        "host", [&] { output_or_fail(c.out(), 1, Time{milliseconds{1}}); }, &host.sun);
    CHECK_THROWS_WITH_AS(
        host.simulation.run(),
        "channel c is broadcast with other channels: its messages cannot be given up, and its ends cannot be reset",
        std::logic_error);
}
