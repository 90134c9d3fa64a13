#include "runtime/hardware/constants.hpp"
#include "runtime/hardware/link_timing.hpp"
#include "runtime/hardware/router.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <utility>

using namespace placedpar::hardware;

namespace {

double value_of(std::string_view group, std::string_view name) {
    const std::vector<Constant> all = constants();
    auto found = std::ranges::find_if(all, [&](const Constant& c) { return c.group == group && c.name == name; });
    REQUIRE(found != all.end());
    return found->value;
}

} // namespace

TEST_CASE("every constant is listed once in its group, with its provenance and source") {
    std::set<std::pair<std::string_view, std::string_view>> seen;
    std::string_view group;
    std::set<std::string_view> groups;
    for (const Constant& each : constants()) {
        CAPTURE(each.name);
        CHECK(seen.insert({each.group, each.name}).second);
        CHECK((each.group == group || groups.insert(each.group).second));
        group = each.group;
        CHECK_FALSE(each.source.empty());
        CHECK_FALSE(each.unit.empty());
        CHECK(each.mark != Provenance::workload); // the netlist sets the workload
    }
    CHECK(groups.size() == 7);
}

TEST_CASE("the listed constants give the simulated times") {
    const LinkTiming link{.bits_per_second = 10'000'000};
    auto bits = [](const char* name) { return 100 * value_of("links", name); };
    auto ns = [](placedpar::Time time) { return static_cast<double>(time.count()) / 1000; };
    CHECK(ns(link.data()) == bits("a byte"));
    CHECK(ns(link.acknowledge()) == bits("an acknowledge"));
    CHECK(ns(link.acknowledge_latency()) == bits("time from a byte to its acknowledge"));
    CHECK(ns(link.restart_latency()) == bits("time from an acknowledge to the next byte") +
                                            value_of("links", "additional time before the next byte, at any speed"));
    const RouterPacket packet{.route = nullptr, .acknowledge = true, .last = true, .hop = 0, .bytes = 0};
    CHECK(static_cast<double>(packet.wire_form().total()) == value_of("channels in packets", "header of a packet"));
}
