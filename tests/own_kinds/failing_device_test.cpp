// Tests that an exception from another program's device becomes a UserError that names the node and gives the
// exception's text.

#include "explore/problems.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/fault_kinds.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "observe/trace/tracks.hpp"
#include "tests/own_kinds/token_ring.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <stdexcept>
#include <string>

using namespace placedpar;

namespace {

void throw_in_device(const char* where, const Node& node) {
    if (std::get<std::string>(node.attributes.at("throws")) == where)
        throw std::runtime_error("worn out");
}

/// Throws in the member function named by the attribute `throws`.
class FailingNode final : public MachineNode {
public:
    FailingNode(MachineParts& parts, std::size_t index)
        : MachineNode((throw_in_device("make", parts.network.nodes[index]), parts), index),
          ring_(token_ring().make(parts, index)) {}
    Executive* executive() override { return throw_in_device("executive", node()), nullptr; }
    CarrierPair carriers(std::size_t way) override {
        throw_in_device("carriers", node());
        return ring_->carriers(way);
    }
    void broadcast(const std::function<AnyChannel&(std::size_t)>&) override { throw_in_device("broadcast", node()); }
    FaultEffects suffer(const Fault&) override {
        throw_in_device("suffer", node());
        return {};
    }
    void report(MachineUse&) const override { throw_in_device("report", node()); }

private:
    std::unique_ptr<MachineNode> ring_;
};

DeviceKind failing_ring() {
    using namespace description;
    DeviceKind kind = token_ring();
    kind.name = "failing ring";
    kind.models = {{.name = "FAILING"}};
    kind.attributes.push_back({.value = text("throws", {.by_default = ""}, "where it does"), .json_name = "throws"});
    kind.why_not = [](const Node& node) { return throw_in_device("why_not", node), ""; };
    kind.medium->takes = [](const Attached& attached, const BusAttachment& station) {
        throw_in_device("takes", attached.network.nodes[station.bus]);
        return true;
    };
    kind.medium->ways = [ways = kind.medium->ways](const Attached& attached, std::size_t ring) {
        throw_in_device("ways", attached.network.nodes[ring]);
        return ways(attached, ring);
    };
    kind.faults.front().why_not = [](const Network& network, const Fault& fault) {
        return throw_in_device("fault", network.nodes[fault.node]), "";
    };
    kind.tracks = [](const Network& network, std::size_t ring) {
        throw_in_device("tracks", network.nodes[ring]);
        return std::vector<std::string>{};
    };
    kind.make = make_device<FailingNode>;
    return kind;
}

const Catalogue& catalogue_with_failing_ring() {
    static const Catalogue catalogue = [] {
        add_own_devices({failing_ring()});
        return known_kinds(known_problems(1));
    }();
    return catalogue;
}

/// Returns the message that refuses a ring whose device throws in this function; "" if it is accepted.
std::string what_happens_in(const std::string& where) {
    try {
        ReadResult read = read_netlist_text(
            fmt::format("FAILING (throws = \"{}\") r; workstation w[2]; process p, c;\n"
                        "rep i = 0 for 2 connect w[i].bus[0] to r.slot[i + 1];\n"
                        "use \"csp.producer\" for p; use \"csp.consumer\" for c; p (count = 1); c (count = 1);\n"
                        "place p on w[0]; place c on w[1]; connect p.out to c.in; fault r breaks (from = 1s);",
                        where),
            catalogue_with_failing_ring());
        CAPTURE(render(read));
        REQUIRE(read.network);
        Tracks tracks(*read.network);
        Machine(*read.network, catalogue_with_failing_ring(), 1).run();
    } catch (const UserError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST_CASE("what a device of another program throws names the node that threw it") {
    CHECK(what_happens_in("nowhere") == "");
    for (const std::string where : {"make", "executive", "carriers", "broadcast", "suffer", "report", "why_not",
                                    "takes", "ways", "fault", "tracks"}) {
        CAPTURE(where);
        const std::string said = what_happens_in(where);
        CAPTURE(said);
        CHECK(said.starts_with("netlist:1:"));
        CHECK(said.ends_with(": a ring \"r\": worn out"));
    }
}
