// Tests the changes that `explain` tries, and their effect on a small machine.

#include "explore/explain/changes.hpp"

#include "explore/explain/what_if.hpp"
#include "explore/problems.hpp"
#include "netlist/read.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Two processors and a link; the producer computes while the consumer waits, then sends.
constexpr const char* two_processors =
    "T800 a, b; connect a.link[0] to b.link[0];\n"
    "process p, c; use \"csp.producer\" for p; use \"csp.consumer\" for c;\n"
    "p (count = 20, bytes = 1000, cycles = 20000); c (count = 20); place p on a; place c on b; connect p.out to c.in;";

const Catalogue& all_kinds() {
    static const ProblemRegistry problems = known_problems(1);
    static const Catalogue kinds = known_kinds(problems);
    return kinds;
}

Network network_with(const std::string& text) {
    ReadResult result = read_netlist_text(text, all_kinds(), {}, "no-such-file.cfs");
    CAPTURE(render(result));
    REQUIRE(result.network);
    return std::move(*result.network);
}

/// Returns the changed netlist. Throws UserError if it is refused.
Network changed(const Overrides& set) {
    ReadResult result = read_netlist_text(two_processors, all_kinds(), set);
    if (!result.network)
        throw UserError(render(result));
    return std::move(*result.network);
}

/// The netlist has no vals, so overrides declare no further processes or processors.
Declared nothing_more(const Overrides&) { return {}; }

std::vector<Change> changes_of_text(const std::string& text) {
    const Network network = network_with(text);
    return changes_of(network, run_netlist(network, all_kinds(), {}), nothing_more);
}

const Change* find_change(const std::vector<Change>& changes, const std::string& what, const std::string& change) {
    auto found =
        std::ranges::find_if(changes, [&](const Change& each) { return each.what == what && each.change == change; });
    return found == changes.end() ? nullptr : &*found;
}

} // namespace

TEST_CASE("the changes include faster processors: all processors, each array and each processor, at three speeds") {
    const std::vector<Change> changes = changes_of_text(two_processors);
    const Change* both = find_change(changes, "all processors", "twice as fast");
    REQUIRE(both);
    CHECK(both->set == Overrides{{"a.clock", "40000000"}, {"b.clock", "40000000"}});
    const Change* one = find_change(changes, "processor of p", "10 % faster");
    REQUIRE(one);
    CHECK(one->set == Overrides{{"a.clock", "22000000"}});
    const Change* most = find_change(changes, "processor of c", "as fast as can be");
    REQUIRE(most);
    CHECK(most->set == Overrides{{"b.clock", "1000000000"}});
}

TEST_CASE("each change is tried once") {
    const std::vector<Change> changes = changes_of_text(two_processors);
    for (std::size_t i = 0; i < changes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            CHECK_FALSE((changes[i].what == changes[j].what && changes[i].change == changes[j].change));
}

TEST_CASE("every change sets an existing parameter to a value that the netlist accepts") {
    for (const Change& change : changes_of_text(two_processors)) {
        CAPTURE(change.what);
        CAPTURE(change.change);
        CHECK_FALSE(change.set.empty());
        if (change.change != "none")
            CHECK_NOTHROW(changed(change.set));
    }
}

TEST_CASE("the answers begin with the shortest run, and a change without effect leaves the time equal") {
    const Network network = network_with(two_processors);
    const Time now = run_netlist(network, all_kinds(), {}).result.time;
    const std::vector<Change> changes{
        {Change::Of::all, "nothing", "as it is", {}},
        {Change::Of::alone, "p", "half", {{"p.cycles", "10000"}}},
        {Change::Of::alone, "p", "less", {{"p.cycles", "0"}}},
        {Change::Of::alone, "p", "refused", {{"p.cycles", "-1"}}},
    };
    const Interruption none;
    const std::vector<Answer> answers =
        try_out(changes, {}, {changed, 1, Time::max(), none, [](std::size_t, std::size_t) {}, 2});
    REQUIRE(answers.size() == 4);
    CHECK(answers[0].change.change == "less");
    CHECK(answers[1].change.change == "half");
    CHECK(answers[2].time == now);
    CHECK(answers[0].time < answers[1].time);
    CHECK(answers[1].time < now);
    CHECK(answers[3].refused.find("out of range") != std::string::npos);
}
