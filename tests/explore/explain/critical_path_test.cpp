// The program keeps only the part of a run's history that the critical path can still use, up to a limit.

#include "explore/explain/explanation.hpp"

#include "explore/load.hpp"
#include "explore/netlist_run.hpp"
#include "explore/problems.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>
#include <tuple>
#include <vector>

using namespace placedpar;

namespace {

Network example(const std::string& name, const Overrides& set = {}) {
    return load_network(fmt::format("{}/examples/{}", PLACEDPAR_SOURCE_DIR, name), set, known_problems(1),
                        [](const std::string&) {});
}

CriticalPath path_of(const Network& network, std::size_t most) {
    CriticalPath path(most);
    run_netlist(network, known_problems(1), {.trace = &path});
    return path;
}

std::vector<std::string> texts_of(const CriticalPath& path) {
    std::vector<std::string> texts;
    for (const PathPart& part : path.parts())
        texts.push_back(fmt::format("{} {} {} {} {}", name_on_path(part.activity), part.subject, part.place,
                                    part.begin.count(), part.end.count()));
    return texts;
}

std::vector<std::string> texts_of(const Account& account) {
    std::vector<std::string> texts{fmt::format("{} {} {} {} {}", account.computing.count(), account.ready.count(),
                                               account.communicating.count(), account.delayed.count(),
                                               account.waiting.count())};
    for (const auto& [partner, time] : account.waiting_for)
        texts.push_back(fmt::format("{} {}", partner, time.count()));
    return texts;
}

void check_same_tables(const CriticalPath& a, const CriticalPath& b) {
    CHECK(a.waits_at_links() == b.waits_at_links());
    REQUIRE(a.accounts().size() == b.accounts().size());
    for (const auto& [process, account] : a.accounts())
        CHECK(texts_of(account) == texts_of(b.accounts().at(process)));
}

} // namespace

TEST_CASE("forgetting points that cannot be on the path leaves the path unchanged") {
    for (const auto& [name, most] :
         {std::pair("thesis/figure-e2/figure-e2.cfs", 32'000), std::pair("machine/busy-bus/busy-bus.cfs", 1000),
          std::pair("machine/through-routing/farm.cfs", 32'000)}) {
        CAPTURE(name);
        Network network = example(name);
        CriticalPath all = path_of(network, most_path_points),
                     forgetful = path_of(network, static_cast<std::size_t>(most));
        CHECK_FALSE(forgetful.too_long());
        CHECK(texts_of(forgetful) == texts_of(all));
        check_same_tables(forgetful, all);
    }
}

TEST_CASE("a path that is too long is not kept, but its accounts are") {
    for (const std::string name :
         {"thesis/figure-e2/figure-e2.cfs", "machine/busy-bus/busy-bus.cfs", "csp/commstime/commstime.cfs"}) {
        CAPTURE(name);
        Network network = example(name);
        CriticalPath all = path_of(network, most_path_points), given_up = path_of(network, 100);
        CHECK(given_up.too_long());
        CHECK(given_up.parts().empty());
        check_same_tables(given_up, all);
    }
}

TEST_CASE("the report of a run whose path was not kept says what to do") {
    Network network = example("csp/commstime/commstime.cfs");
    Explanation explanation;
    explanation.path_too_long = true;
    const std::string why =
        "it has more than 2000000 parts; end the run earlier with --until, or shorten it with --set";
    std::string printed = print_explanation(explanation, network);
    CHECK(printed.find("\ncritical path: too long to keep: " + why + "\n") != std::string::npos);
    CHECK(printed.find("share") == std::string::npos);
    CHECK(explanation_json(explanation, network).at("not_kept").as_string() == why);
}

TEST_CASE("points that are not among the causes of a current point are forgotten") {
    PathPoints points(8);
    auto add = [&](PathPoints::Number before, int at) {
        return points.add({Time{at}, before, Activity::computing, 0, 0});
    };
    add(0, 0);
    PathPoints::Number one = add(0, 1), other = add(0, 1);
    for (int at = 2; at < 5; ++at) {
        one = add(one, at);
        other = add(other, at);
    }
    CHECK(points.should_forget());
    std::vector<PathPoints::Number*> in_use{&one};
    points.forget_but(in_use);
    CHECK_FALSE(points.too_long());
    CHECK(one == 4);
    CHECK(points[one].at == Time{4});
    CHECK(points[points[one].before].at == Time{3});
    while (!points.should_forget())
        one = add(one, 5);
    points.forget_but(in_use);
    CHECK(points.too_long());
    CHECK(one == 2); // the beginning, the point before this point, and this point
}
