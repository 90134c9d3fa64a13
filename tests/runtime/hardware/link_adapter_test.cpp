#include "runtime/hardware/link_adapter.hpp"

#include "runtime/alternation.hpp"
#include "runtime/channel.hpp"
#include "runtime/hardware/bus_programs.hpp"
#include "runtime/hardware/processor.hpp"
#include "runtime/hardware/workstation.hpp"
#include "runtime/parallel.hpp"
#include "runtime/simulation.hpp"
#include "runtime/timer.hpp"

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

namespace {

using Octets = std::vector<std::uint8_t>;
constexpr LinkTiming adapter_timing{.overlapped_acknowledge = false};

/// A Sun on a bus with an adapter, whose link leads to a transputer.
struct Host {
    explicit Host(std::int64_t most_polls = 32) : program(bus_programs::sun_3_280) { program.most_polls = most_polls; }

    Simulation simulation;
    BusProgram program;
    VmeBus& bus = simulation.add<VmeBus>("bus");
    Workstation& sun = simulation.add<Workstation>("sun");
    VmeMaster& master = simulation.add<VmeMaster>("sun", bus, VmePlace{}, program);
    Processor& t800 = simulation.add<Processor>("t800");
    Link& link = simulation.add<Link>(adapter_timing, "adapter.link[0]", "t800.link[0]");
    LinkAdapter& adapter = simulation.add<LinkAdapter>("adapter", link, LinkAdapter::End::a);
    AdapterProgram& driver = simulation.add<AdapterProgram>(master, adapter);
};

/// Of a register: the program, the arbitration, the cycle.
constexpr Time register_access = duration_of(30, 25'000'000) + nanoseconds{200} + nanoseconds{310};

/// When `bytes` have been written and the last one is acknowledged, by the rules of polling alone.
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

/// When `bytes` have been read that an engine has sent since the beginning.
Time time_of_reading(int bytes) {
    Time t{}, here = duration_of(19, 20'000'000) + adapter_timing.acknowledge_latency(); // behind the instruction
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

TEST_CASE("a host writes bytes to an adapter as fast as polling and the link let it") {
    for (int bytes : {1, 2, 7, 100}) {
        Host host(1'000'000);
        Channel<Octets> c("c");
        c.put_on(host.driver.to_link());
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
        CHECK(done == time_of_writing(4) + time_of_writing(bytes)); // INT::[]BYTE: the count goes first
        CHECK(host.link.from_a_to_b().bytes_carried() == static_cast<std::uint64_t>(4 + bytes));
    }
}

TEST_CASE("the times of a single part are those of the rules") {
    struct Block {
        char bytes[100];
    };
    SUBCASE("written") {
        Host host(1'000'000);
        Channel<Block> c("c");
        c.put_on(host.driver.to_link());
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
        Channel<Block> c("c");
        c.put_on(host.driver.from_link());
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

TEST_CASE("messages of every length come over whole and in order, both ways at once") {
    Host host;
    Channel<Octets> down("down"), up("up");
    down.put_on(host.driver.to_link());
    up.put_on(host.driver.from_link());
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

TEST_CASE("a host that has polled in vain sleeps until the adapter's interrupt") {
    Host host;
    Channel<std::int32_t> c("c");
    c.put_on(host.driver.from_link());
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
    Channel<std::int32_t> first("first"), second("second");
    first.put_on(host.driver.from_link());
    second.put_on(driver.from_link());
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

TEST_CASE("a transputer that never answers is a deadlock, and the host is named in it") {
    Host host;
    Channel<std::int32_t> c("c");
    c.put_on(host.driver.from_link());
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
            channels.back().put_on(at_once ? broadcast.lane(i) : drivers[i]->to_link());
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
    // for each of 152 bytes: four times status and data, or four times the status and once the data
    CHECK(one_by_one >= 2 * nodes * 152 * register_access);
    CHECK(at_once >= (nodes + 1) * 152 * register_access);
    CHECK(at_once < (nodes + 2) * 152 * register_access);
}
