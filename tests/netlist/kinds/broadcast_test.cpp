// Tests channels that the netlist places on a bus: one message for several link adapters.

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/packet.hpp"
#include "netlist/machine.hpp"
#include "netlist/print/print.hpp"
#include "netlist/print/promela.hpp"
#include "netlist/read.hpp"
#include "runtime/parallel.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace placedpar;

namespace {

/// Sends `count` packets of `bytes` to all outputs in parallel; the packets to the last output are `more` bytes longer.
void shout(ProcessEnvironment& environment) {
    auto to = environment.outputs<Packet>("out");
    for (std::int64_t i = 0; i < environment.integer("count"); ++i)
        par_for(to.size(), [&](std::size_t k) {
            auto more = k + 1 == to.size() ? environment.integer("more") : 0;
            auto number = k + 1 == to.size() ? environment.integer("other") + i : i;
            to[k].output({number, static_cast<std::uint32_t>(environment.integer("bytes") + more)});
        });
}

const Catalogue& broadcasting_catalogue() {
    static const Catalogue known = [] {
        using namespace description;
        Catalogue all;
        add_csp_kinds(all);
        all.add(
            {.name = "test.shout",
             .about = "Outputs packets to all at once.",
             .ports = {packets_out()},
             .parameters = {packet_count(), packet_bytes(),
                            description::integer("more", {.by_default = 0}, "for the last"),
                            description::integer("other", {.by_default = 0}, "number of the last one's first packet")},
             .body = shout});
        return all;
    }();
    return known;
}

/// A producer on the workstation, and a consumer on each of three transputers behind link adapters.
std::string one_to_three(const std::string& more = "rep i = 0 for 3 place p.out[i] on vme;") {
    return R"(VME vme; workstation (clock = 25M) sun; C012 adapter[3]; T800 t[3];
        connect sun.bus[0] to vme.slot[1];
        process (interface (output out[3])) p;
        process (interface (input in)) c[3];
        use "test.shout" for p; use "csp.consumer" for c;
        p (count = 5, bytes = 200); c (count = 5);
        place p on sun;
        rep i = 0 for 3 {
            connect adapter[i].bus[0] to vme.slot[2 + i];
            connect adapter[i].link[0] to t[i].link[i];
            connect p.out[i] to c[i].in;
            place c[i] on t[i];
        } )" +
           more;
}

Network network_of_broadcast(const std::string& text) {
    ReadResult result = read_netlist_text(text, broadcasting_catalogue(), {});
    INFO(render(result));
    REQUIRE(result.network);
    return *result.network;
}

void replace(std::string& text, const std::string& part, const std::string& by) {
    auto at = text.find(part);
    REQUIRE(at != std::string::npos);
    text.replace(at, part.size(), by);
}

RunReport run_broadcast(const std::string& text) {
    return Machine(network_of_broadcast(text), broadcasting_catalogue(), 1).run();
}

} // namespace

TEST_CASE("channels placed on a bus form one broadcast, which writes each byte once") {
    RunReport each = run_broadcast(one_to_three("")), all = run_broadcast(one_to_three());
    for (const RunReport* report : {&each, &all}) {
        CHECK(report->result.ending == Ending::completed);
        for (const char* consumer : {"c[0]", "c[1]", "c[2]"})
            CHECK(report->measured(consumer, "last_number") == 4);
        for (const LinkUse& link : report->links)
            CHECK(link.bytes == (link.from.starts_with("adapter") ? 5 * 200 : 0));
    }
    CHECK(each.buses[0].broadcasts.empty());
    REQUIRE(all.buses[0].broadcasts.size() == 1);
    const BroadcastUse& use = all.buses[0].broadcasts[0];
    CHECK(use.from == "p.out");
    CHECK(use.adapters == 3);
    CHECK(use.messages == 5);
    CHECK(use.bytes == 5 * 200);
    // A byte costs one access to each status, and one write for each adapter, or a single write if broadcast. Each
    // message costs one more status access at its end.
    auto accesses = [](const RunReport& report) { return report.buses[0].masters[0].bytes; };
    CHECK(accesses(each) >= 5 * (2 * 3 * 200));
    CHECK(accesses(all) >= 5 * ((3 + 1) * 200 + 3));
    CHECK(accesses(all) < 5 * (3 + 2) * 200);
    // No other master uses the bus: each access takes 30 program cycles, the arbitration and one bus cycle.
    Time access = duration_of(30, 25'000'000) + std::chrono::nanoseconds{200 + 310};
    CHECK(all.buses[0].busy == static_cast<std::int64_t>(accesses(all)) * std::chrono::nanoseconds{310});
    CHECK(all.result.time >= static_cast<std::int64_t>(accesses(all)) * access);
    CHECK(all.result.time < each.result.time);
}

TEST_CASE("a part of a port array may be broadcast; the other elements are separate channels") {
    RunReport report = run_broadcast(one_to_three("rep i = 0 for 2 place p.out[i] on vme;"));
    CHECK(report.result.ending == Ending::completed);
    REQUIRE(report.buses[0].broadcasts.size() == 1);
    CHECK(report.buses[0].broadcasts[0].adapters == 2);
    CHECK(report.buses[0].broadcasts[0].messages == 5);
}

TEST_CASE("the printed form of a network with a broadcast loads as the same network") {
    Network network = network_of_broadcast(one_to_three());
    std::string printed = print_cfs(network);
    CHECK(printed.find("place p.out[1] on vme;\nplace c[1].in on t[1].link[1];\n") != std::string::npos);
    Network again = network_of_broadcast(printed);
    CHECK(print_cfs(again) == printed);
    CHECK(again.hash == network.hash);
    CHECK(network.hash != network_of_broadcast(one_to_three("")).hash);
    CHECK(print_json(network).find("\"broadcast_on\": \"vme\"") != std::string::npos);
}

TEST_CASE("a broadcast uses the stated adapter of the receiver's processor, or a free one") {
    std::string two = R"(VME vme; workstation (clock = 25M) sun; C012 a[2]; T800 t;
        connect sun.bus[0] to vme.slot[1];
        rep i = 0 for 2 { connect a[i].bus[0] to vme.slot[2]; connect a[i].link[0] to t.link[2 + i]; }
        process (interface (output out[2])) p; process (interface (input in)) c[2];
        use "test.shout" for p; use "csp.consumer" for c; p (count = 2); c (count = 2);
        place p on sun;
        rep i = 0 for 2 { connect p.out[i] to c[i].in; place c[i] on t; place p.out[i] on vme; } )";
    auto link_of = [](const Network& network, std::size_t channel) {
        return end_of(network.channels[channel].placement.route[0], network.connections).link;
    };
    Network by_choice = network_of_broadcast(two), told = network_of_broadcast(two + "place c[0].in on t.link[3];");
    CHECK(link_of(by_choice, 0) == 2);
    CHECK(link_of(by_choice, 1) == 3);
    CHECK(link_of(told, 0) == 3);
    CHECK(link_of(told, 1) == 2);
    CHECK(Machine(told, broadcasting_catalogue(), 1).run().buses[0].broadcasts[0].adapters == 2);
}

namespace {

/// Returns a netlist in which a process of this kind passes on the packets of a producer.
std::string passed_on_by(const std::string& kind) {
    std::string text = one_to_three();
    replace(text, "\"test.shout\" for p", "\"" + kind + "\" for p");
    replace(text, "p (count = 5, bytes = 200);",
            "process (interface (output out)) q; use \"csp.producer\" for q; place q on sun;"
            "q (count = 5); p (count = 5); connect q.out to p.in;");
    replace(text, "(output out[3])) p", "(input in, output out[3])) p");
    return text;
}

} // namespace

TEST_CASE("a process that outputs to all receivers in a PAR broadcasts") {
    RunReport report = run_broadcast(passed_on_by("csp.par_delta"));
    CHECK(report.result.ending == Ending::completed);
    CHECK(report.buses[0].broadcasts[0].messages == 5);
    for (const char* consumer : {"c[0]", "c[1]", "c[2]"})
        CHECK(report.measured(consumer, "last_number") == 4);
}

TEST_CASE("a process that outputs to the receivers in turn waits for ever, and the report names the awaited output") {
    RunReport report = run_broadcast(passed_on_by("csp.delta"));
    CHECK(report.result.ending == Ending::stuck);
    REQUIRE(report.result.deadlock);
    CHECK(report.result.deadlock->cycle == std::vector<std::string>{"p"});
    CHECK(
        report.result.deadlock->held_up ==
        std::vector<std::string>{
            "p.out[0] -> c[0].in: waits until the message is output on p.out[1] -> c[1].in, p.out[2] -> c[2].in, too, "
            "because one message goes to all these channels: output it on all of them in a PAR"});
}

TEST_CASE("a broadcast of different messages is an error with the process and its place") {
    auto refused = [](const std::string& parameters) {
        std::string text = one_to_three();
        replace(text, "bytes = 200", parameters);
        try {
            run_broadcast(text);
        } catch (const UserError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    std::string longer = refused("bytes = 200, more = 4"), other = refused("other = 1");
    for (const std::string& each : {longer, other}) {
        CAPTURE(each);
        CHECK(each.find("3:45: process p/2 (test.shout)") != std::string::npos);
        CHECK(each.find("channel p.out[2] -> c[2].in is broadcast with p.out[0] -> c[0].in, but its message ") !=
              std::string::npos);
        CHECK(each.find("hint: all channels of a broadcast carry the same messages") != std::string::npos);
    }
    CHECK(longer.find("has 204 bytes, not 200 bytes") != std::string::npos);
    CHECK(other.find("differs") != std::string::npos);
}

TEST_CASE("a broadcast cannot be printed as a model for Spin") {
    std::string text = one_to_three();
    replace(text, "\"test.shout\" for p", "\"csp.producer\" for p");
    CHECK_THROWS_WITH_AS(print_promela(network_of_broadcast(text), broadcasting_catalogue()),
                         doctest::Contains("p.out[0] -> c[0].in"), UserError);
}
