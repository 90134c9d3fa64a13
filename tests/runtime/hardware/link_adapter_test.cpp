#include "runtime/hardware/link_adapter.hpp"

#include "runtime/alternation.hpp"
#include "runtime/channel.hpp"
#include "runtime/hardware/bus_programs.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/workstation.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"
#include "tests/runtime/hardware/adapter_host.hpp"

#include <doctest/doctest.h>

#include <cstdint>
#include <iterator>
#include <list>
#include <string>
#include <vector>

using namespace placedpar;
using namespace placedpar::hardware;
using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;
using test::adapter_timing;
using test::Host;
using test::Octets;

namespace {

/// The time of an access to a register: program, arbitration, bus cycle.
constexpr Time register_access = duration_of(30, 25'000'000) + nanoseconds{200} + nanoseconds{310};

/// Returns the time at which `bytes` bytes have been written and the last is acknowledged. It is computed only from the
/// rules of polling.
Time time_of_writing(int bytes) {
    Time t{}, free{};
    auto poll = [&] {
        do
            t += register_access;
        while (t < free);
    };
    for (int i = 0; i < bytes; ++i) {
        poll();
        t += register_access;
        free = t + adapter_timing.acknowledge_latency() + adapter_timing.restart_latency();
    }
    poll();
    return t;
}

/// Returns the time at which `bytes` bytes have been read. A link engine sends from the beginning.
Time time_of_reading(int bytes) {
    Time t{}, here = duration_of(19, 20'000'000) + adapter_timing.acknowledge_latency(); // after the instruction
    for (int i = 0; i < bytes; ++i) {
        do
            t += register_access;
        while (t < here);
        t += register_access;
        here = t + adapter_timing.restart_latency() + adapter_timing.acknowledge_latency();
    }
    return t;
}

double kilobytes_per_second(int bytes, Time time) { return bytes / (static_cast<double>(time.count()) * 1e-12) / 1e3; }

} // namespace

TEST_CASE("a host writes bytes to an adapter as fast as polling and the link allow") {
    for (int bytes : {1, 2, 7, 100}) {
        Host host(1'000'000);
        Channel<Octets> c("c", host.driver.to_link());
        Time done{};
        std::size_t received = 0;
        host.simulation.process(
            "host",
            [&] {
                c.out().output(Octets(static_cast<std::size_t>(bytes), 1));
                done = now();
            },
            &host.sun);
        host.simulation.process(
            "node", [&] { received = c.in().input().size(); }, &host.t800);
        CHECK(host.simulation.run().ending == Ending::completed);
        CHECK(received == static_cast<std::size_t>(bytes));
        CHECK(done == time_of_writing(4) + time_of_writing(bytes)); // INT::[]BYTE: the count is sent first
        CHECK(host.link.from_a_to_b().bytes_carried() == static_cast<std::uint64_t>(4 + bytes));
    }
}

TEST_CASE("a single part takes the time computed from the rules of polling") {
    struct Block {
        char bytes[100];
    };
    SUBCASE("written") {
        Host host(1'000'000);
        Channel<Block> c("c", host.driver.to_link());
        Time done{};
        host.simulation.process(
            "host", [&] { c.out().output({}), done = now(); }, &host.sun);
        host.simulation.process("node", [&] { c.in().input(); });
        CHECK(host.simulation.run().ending == Ending::completed);
        CHECK(done == time_of_writing(100));
        double rate = kilobytes_per_second(100, done);
        CHECK(rate > 43);
        CHECK(rate < 400);
    }
    SUBCASE("read") {
        Host host(1'000'000);
        Channel<Block> c("c", host.driver.from_link());
        Time done{};
        host.simulation.process(
            "host", [&] { c.in().input(), done = now(); }, &host.sun);
        host.simulation.process(
            "node", [&] { c.out().output({}); }, &host.t800);
        CHECK(host.simulation.run().ending == Ending::completed);
        CHECK(done == time_of_reading(100));
        double rate = kilobytes_per_second(100, done);
        CHECK(rate > 43);
        CHECK(rate < 400);
    }
}

TEST_CASE("messages of every length arrive completely and in order, in both directions at once") {
    Host host;
    Channel<Octets> down("down", host.driver.to_link()), up("up", host.driver.from_link());
    std::vector<Octets> sent, back;
    for (std::size_t n = 0; n < 20; ++n)
        sent.emplace_back(n, static_cast<std::uint8_t>(n));
    host.simulation.process(
        "sender",
        [&] {
            for (const Octets& each : sent)
                down.out().output(each);
        },
        &host.sun);
    host.simulation.process(
        "receiver",
        [&] {
            for (std::size_t n = 0; n < sent.size(); ++n)
                back.push_back(up.in().input());
        },
        &host.sun);
    host.simulation.process(
        "node",
        [&] {
            for (std::size_t n = 0; n < sent.size(); ++n)
                up.out().output(down.in().input());
        },
        &host.t800);
    CHECK(host.simulation.run().ending == Ending::completed);
    CHECK(back == sent);
}

TEST_CASE("a host sleeps after unsuccessful polls until the adapter's interrupt") {
    Host host;
    Channel<std::int32_t> c("c", host.driver.from_link());
    Time got{};
    host.simulation.process(
        "host", [&] { c.in().input(), got = now(); }, &host.sun);
    host.simulation.process(
        "node", [&] { compute(Cycles{2'000'000}), c.out().output(7); }, &host.t800);
    CHECK(host.simulation.run().ending == Ending::completed);
    CHECK(got > milliseconds{100} + microseconds{100});
    CHECK(got < milliseconds{100} + microseconds{140});
    CHECK(host.master.bytes_accessed() < 32 + 20);
}

TEST_CASE("a host can wait for several adapters in an alternation") {
    Host host;
    auto& link = host.simulation.add<Link>(adapter_timing, "b.link[0]", "t801.link[0]");
    auto& adapter = host.simulation.add<LinkAdapter>("b", link, LinkAdapter::End::b);
    auto& driver = host.simulation.add<AdapterProgram>(host.master, adapter);
    Channel<std::int32_t> first("first", host.driver.from_link()), second("second", driver.from_link());
    std::string order;
    host.simulation.process(
        "host",
        [&] {
            for (int i = 0; i < 2; ++i)
                alt(on(first.in(), [&](std::int32_t) { order += '1'; }),
                    on(second.in(), [&](std::int32_t) { order += '2'; }));
        },
        &host.sun);
    host.simulation.process("a", [&] { wait_for(milliseconds{2}), first.out().output(1); });
    host.simulation.process("b", [&] { wait_for(milliseconds{1}), second.out().output(2); });
    CHECK(host.simulation.run().ending == Ending::completed);
    CHECK(order == "21");
}

TEST_CASE("a transputer that never answers is a deadlock that names the host") {
    Host host;
    Channel<std::int32_t> c("c", host.driver.from_link());
    host.simulation.process(
        "host", [&] { c.in().input(); }, &host.sun);
    RunResult result = host.simulation.run();
    CHECK(result.ending == Ending::stuck);
    REQUIRE(result.deadlock);
    CHECK(result.deadlock->processes.front().path == "host");
}

TEST_CASE("a broadcast writes each byte once for all adapters") {
    constexpr int nodes = 4;
    auto time_of = [&](bool at_once) {
        Host host;
        std::vector<AdapterProgram*> drivers{&host.driver};
        for (int i = 1; i < nodes; ++i) {
            auto& link = host.simulation.add<Link>(adapter_timing, "a" + std::to_string(i), "t" + std::to_string(i));
            auto& adapter = host.simulation.add<LinkAdapter>("a" + std::to_string(i), link, LinkAdapter::End::a);
            drivers.push_back(&host.simulation.add<AdapterProgram>(host.master, adapter));
        }
        auto& broadcast = host.simulation.add<AdapterBroadcast>(drivers);
        std::list<Channel<Octets>> channels;
        std::vector<Octets> received(nodes);
        for (std::size_t i = 0; i < nodes; ++i) {
            channels.emplace_back("c" + std::to_string(i));
            if (at_once)
                broadcast.carry(channels.back(), i);
            else
                channels.back().put_on(drivers[i]->to_link());
            host.simulation.process("node" + std::to_string(i),
                                    [&, i, &c = channels.back()] { received[i] = c.in().input(); });
        }
        Time done{};
        host.simulation.process(
            "host",
            [&] {
                par_for(nodes, [&](std::size_t i) {
                    std::next(channels.begin(), static_cast<std::ptrdiff_t>(i))->out().output(Octets(148, 5));
                });
                done = now();
            },
            &host.sun);
        CHECK(host.simulation.run().ending == Ending::completed);
        CHECK(received == std::vector<Octets>(nodes, Octets(148, 5)));
        CHECK(broadcast.messages() == (at_once ? 1u : 0u));
        return done;
    };
    Time one_by_one = time_of(false), at_once = time_of(true);
    CHECK(at_once < one_by_one);
    // Without a broadcast, each of the 152 bytes takes four accesses to the status and four to the data. With a
    // broadcast it takes four accesses to the status and one to the data.
    CHECK(one_by_one >= 2 * nodes * 152 * register_access);
    CHECK(at_once >= (nodes + 1) * 152 * register_access);
    CHECK(at_once < (nodes + 2) * 152 * register_access);
}

namespace {

/// A host with several adapters on its bus and a transputer at each adapter. It broadcasts to all of them on channels
/// c0, c1, ...
template <class T>
struct BroadcastingHost : Host {
    explicit BroadcastingHost(std::size_t nodes, std::int64_t most_polls = 32) : Host(most_polls) {
        std::vector<AdapterProgram*> drivers{&driver};
        while (drivers.size() < nodes) {
            std::string name = "a" + std::to_string(drivers.size());
            auto& wire = simulation.add<Link>(adapter_timing, name, "t" + std::to_string(drivers.size()));
            auto& one_more = simulation.add<LinkAdapter>(name, wire, LinkAdapter::End::a);
            drivers.push_back(&simulation.add<AdapterProgram>(master, one_more));
        }
        broadcast = &simulation.add<AdapterBroadcast>(drivers);
        for (std::size_t i = 0; i < nodes; ++i)
            broadcast->carry(channels.emplace_back("c" + std::to_string(i)), i);
    }

    Channel<T>& channel(std::size_t i) { return *std::next(channels.begin(), static_cast<std::ptrdiff_t>(i)); }
    void add_receivers() {
        for (std::size_t i = 0; i < channels.size(); ++i) {
            auto receive = [&c = channel(i)] { c.in().input(); };
            simulation.process("node" + std::to_string(i), {channel(i).in()}, receive);
        }
    }

    AdapterBroadcast* broadcast;
    std::list<Channel<T>> channels;
};

/// Returns the time at which a broadcast has been written. As in time_of_writing, but the status of each adapter is
/// polled in turn, and each byte is written once.
Time time_of_broadcasting(int bytes, std::size_t adapters) {
    Time t{}, free{};
    auto poll_all = [&] {
        for (std::size_t i = 0; i < adapters; ++i)
            do
                t += register_access;
            while (t < free);
    };
    for (int i = 0; i < bytes; ++i) {
        poll_all();
        t += register_access;
        free = t + adapter_timing.acknowledge_latency() + adapter_timing.restart_latency();
    }
    poll_all();
    return t;
}

} // namespace

TEST_CASE("a broadcast takes the time of its accesses, to the picosecond") {
    for (std::size_t nodes : {std::size_t{1}, std::size_t{2}, std::size_t{5}})
        for (int bytes : {1, 2, 60}) {
            CAPTURE(nodes);
            CAPTURE(bytes);
            BroadcastingHost<Octets> host(nodes, 1'000'000);
            Time done{};
            host.add_receivers();
            host.simulation.process(
                "host",
                [&] {
                    par_for(nodes, [&](std::size_t i) {
                        host.channel(i).out().output(Octets(static_cast<std::size_t>(bytes), 1));
                    });
                    done = now();
                },
                &host.sun);
            CHECK(host.simulation.run().ending == Ending::completed);
            CHECK(done == time_of_broadcasting(4, nodes) + time_of_broadcasting(bytes, nodes));
            CHECK(done == static_cast<std::int64_t>(host.master.bytes_accessed()) * register_access);
            CHECK(host.broadcast->messages() == 1);
            CHECK(host.broadcast->bytes() == static_cast<std::uint64_t>(4 + bytes));
        }
}

TEST_CASE("different messages on the channels of a broadcast are refused") {
    auto run = [](auto first, auto second) {
        BroadcastingHost<decltype(first)> host(2);
        host.add_receivers();
        host.simulation.process(
            "host",
            [&] { par([&] { host.channel(0).out().output(first); }, [&] { host.channel(1).out().output(second); }); },
            &host.sun);
        host.simulation.run();
    };
    CHECK_NOTHROW(run(Octets{1, 2}, Octets{1, 2}));
    CHECK_THROWS_WITH_AS(run(Octets{1, 2}, Octets{1, 2, 3}),
                         doctest::Contains("channel c1 is broadcast with c0, but its message has 4 + 3 bytes, not 4 + "
                                           "2 bytes"),
                         BroadcastError);
    CHECK_THROWS_WITH_AS(run(Octets{1, 2}, Octets{1, 3}),
                         doctest::Contains("channel c1 is broadcast with c0, but its message differs"), BroadcastError);
    struct WithoutEquality {
        double number = 0;
    };
    CHECK_THROWS_WITH_AS(run(WithoutEquality{}, WithoutEquality{}), doctest::Contains("their type has no =="),
                         BroadcastError);
}

TEST_CASE("a program that outputs on a broadcast's channels in sequence is stuck, and the report gives the reason") {
    BroadcastingHost<std::int32_t> host(3);
    host.add_receivers();
    auto output_in_order = [&] {
        for (Channel<std::int32_t>& each : host.channels)
            each.out().output(7);
    };
    host.simulation.process("host", {host.channel(0).out(), host.channel(1).out(), host.channel(2).out()},
                            output_in_order, &host.sun);
    SUBCASE("at the end of the run") {
        RunResult result = host.simulation.run();
        CHECK(result.ending == Ending::stuck);
        REQUIRE(result.deadlock);
        CHECK(result.deadlock->cycle == std::vector<std::string>{"host"});
        REQUIRE(result.deadlock->held_up.size() == 1);
        CHECK(result.deadlock->held_up[0] ==
              "c0: waits until the message is output on c1, c2, too, because one message goes to all these channels: "
              "output it on all of them in a PAR");
    }
    SUBCASE("while others could go on") {
        host.simulation.process("other", [] { wait_for(milliseconds{5}); });
        RunResult result = host.simulation.run(milliseconds{1});
        CHECK(result.ending == Ending::time_limit);
        REQUIRE(result.deadlock);
        CHECK(result.deadlock->processes.size() == 4);
    }
}

TEST_CASE("a receiver that does not come holds up the others, which the report does not blame") {
    BroadcastingHost<std::int32_t> host(3);
    for (std::size_t i : {std::size_t{0}, std::size_t{2}})
        host.simulation.process("node" + std::to_string(i), [&c = host.channel(i)] { c.in().input(); });
    Channel<int> never("never");
    host.simulation.process("node1", {host.channel(1).in()}, [&] { never.in().input(); });
    host.simulation.process(
        "host", [&] { par_for(3, [&](std::size_t i) { host.channel(i).out().output(7); }); }, &host.sun);
    RunResult result = host.simulation.run();
    CHECK(result.ending == Ending::stuck);
    REQUIRE(result.deadlock);
    CHECK(result.deadlock->cycle.empty());
    REQUIRE(!result.deadlock->held_up.empty());
    CHECK(result.deadlock->held_up[0].find(": waits until the message is taken on c1, too") != std::string::npos);
}
