// Tests slaves in chains, stars and other trees. Each form gives the traditional algorithm's generations, and none
// deadlocks.

#include "gaprocs/traditional.hpp"
#include "runtime/random.hpp"
#include "tests/gaprocs/cluster.hpp"
#include "tests/gaprocs/slave_forms.hpp"
#include "tests/sanitized.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <set>
#include <string>
#include <utility>

using namespace placedpar;

namespace {

constexpr std::size_t most_slaves = 11; // of 12 individuals

/// Returns parameters of a short search.
std::string small_search(const std::string& others = "") {
    return "rehearsals = 1, population = 12, window = 4, first_window = 4, trials = 2, elite = 1" +
           (others.empty() ? "" : ", " + others);
}

std::string populations_of(const FarmOfForm& farm) {
    RunReport report = run_on_line(farm.netlist());
    CHECK(report.result.ending == Ending::completed);
    return report.measured_text("master", "populations");
}

/// Returns the hash of the populations of the same search by one process without slaves.
std::string populations_without_slaves(const FarmOfForm& farm) {
    auto text = fmt::format(
        "workstation sun; T800 t; process host, master; use \"ga.host\" for host; use \"ga.traditional\" for master;\n"
        "connect sun.link[0] to t.link[0]; connect host.to_masters[0] to master.from_host;\n"
        "place host on sun; place master on t; host ({});\n"
        "master (problem = \"line\", stream = \"one stream\", population = 12, window = 4, first_window = 4, "
        "trials = 2, elite = 1);\n",
        farm.host_parameters);
    return run_on_line(text).measured_text("master", "populations");
}

/// Returns parameters for every combination of ways to split the work, to send tasks and to return results.
std::vector<std::string> ways() {
    std::vector<std::string> all;
    for (const char* sending : {"in turn", "at once"}) {
        for (const char* split : {"individuals", "evaluations"})
            for (const char* results : {"chain", "ready"})
                all.push_back(
                    fmt::format("split = \"{}\", results = \"{}\", sending = \"{}\"", split, results, sending));
        for (int under_way : {1, 2, 5})
            all.push_back(
                fmt::format("split = \"demand\", tasks_under_way = {}, sending = \"{}\"", under_way, sending));
    }
    return all;
}

const char* const few_samples = "problem = \"line\", samples = 5";

} // namespace

TEST_CASE("every form, number of slaves and way of sharing the work gives the traditional generations") {
    std::string traditional = populations_without_slaves({.form = {}, .host_parameters = few_samples});
    test::EveryNth sampled(17);
    for (std::size_t slaves : {1u, 2u, 3u, 4u, 7u, 11u}) {
        std::set<SlaveForm> forms{chain_of(slaves), star_of(slaves), tree_of(slaves, 2), tree_of(slaves, 3),
                                  chains_of(slaves, 2)};
        for (const SlaveForm& form : forms)
            for (const std::string& way : ways())
                for (bool on_links : {true, false}) {
                    if (on_links && form == star_of(slaves) && slaves > 3)
                        continue; // a transputer has only four links
                    if (sampled.passes_over())
                        continue;
                    CAPTURE(slaves);
                    CAPTURE(way);
                    CAPTURE(on_links);
                    CHECK(populations_of({.form = form,
                                          .on_links = on_links,
                                          .master_parameters = small_search(way),
                                          .host_parameters = few_samples}) == traditional);
                }
    }
}

TEST_CASE("no random tree of slaves deadlocks, in any placement and timing") {
    std::string traditional = populations_without_slaves({.form = {}, .host_parameters = few_samples});
    const std::array<std::string, 4> processors{"clock = 20M", "clock = 3M", "clock = 25M", "channelcall = 300"};
    for (std::uint64_t seed : test::seeds(60, 1)) {
        RandomStream random(seed, "a form of slaves");
        auto draw = [&](std::size_t choices) -> std::size_t {
            return random.below(static_cast<std::uint32_t>(choices));
        };
        FarmOfForm farm{.form = {}, .on_links = draw(2) == 0, .host_parameters = few_samples};
        std::vector<std::size_t> behind(most_slaves + 1, 0);
        for (std::size_t slaves = 1 + draw(most_slaves); farm.form.size() < slaves;) {
            std::size_t before = draw(farm.form.size() + 1); // the master or an earlier slave
            if (farm.on_links && behind[before] == 3)
                continue;
            ++behind[before];
            farm.form.push_back(before - 1);
        }
        auto all = ways();
        farm.master_parameters =
            small_search(fmt::format("{}, cycles_per_error = {}, cycles_per_measurement_word = {}, string_bytes = {}",
                                     all[draw(all.size())], draw(3) * 700, draw(2) * 144, 1 + draw(40)));
        farm.processors = {processors[draw(4)], processors[draw(4)], processors[draw(4)]};
        INFO(test::replay(seed));
        CHECK(populations_of(farm) == traditional);
    }
}

TEST_CASE("a chain with subscripts takes the same time as a chain without, to the picosecond") {
    auto netlist = Cluster{.slaves = 3}.netlist();
    auto subscripted = netlist;
    for (std::string port : {".to_slaves to", ".from_slaves;"})
        for (auto at = subscripted.find(port); at != std::string::npos; at = subscripted.find(port, at + 1))
            subscripted.insert(at + port.find_first_of(" ;"), "[0]");
    for (std::string port : {"output to_slaves", "input from_slaves"})
        for (auto at = subscripted.find(port); at != std::string::npos; at = subscripted.find(port, at + 1))
            subscripted.insert(at + port.size(), "[1]");
    REQUIRE(subscripted != netlist);
    CHECK(run_on_line(subscripted).result.fingerprint == run_on_line(netlist).result.fingerprint);
}

TEST_CASE("the farthest slave of a chain waits less if it already has the next task") {
    auto run = [](int under_way) {
        FarmOfForm farm{.form = chain_of(3),
                        .master_parameters = fmt::format("rehearsals = 0, population = 120, split = \"demand\", "
                                                         "tasks_under_way = {}, cycles_per_measurement_word = 144",
                                                         under_way),
                        .processors = {"channelcall = 201"}};
        return run_on_line(farm.netlist());
    };
    RunReport one = run(1), two = run(2);
    auto waiting = [](const RunReport& report) { return *report.share(report.processes.back().waiting); };
    CHECK(waiting(two) < 0.8 * waiting(one));
    CHECK(two.measured("master", "T_sr") < 0.99 * one.measured("master", "T_sr"));
    CHECK(two.measured_text("master", "populations") == one.measured_text("master", "populations"));
}

TEST_CASE("a star has less communication time than a chain, and even less with all links at once") {
    auto c_time2 = [](const SlaveForm& form, const char* sending) {
        FarmOfForm farm{.form = form,
                        .master_parameters =
                            fmt::format("rehearsals = 3, string_bytes = 20, sending = \"{}\"", sending)};
        return run_on_line(farm.netlist()).measured("master", "C_time2");
    };
    double chain = c_time2(chain_of(3), "in turn"), star = c_time2(star_of(3), "in turn"),
           at_once = c_time2(star_of(3), "at once");
    CHECK(star < 0.9 * chain);
    CHECK(at_once < 0.9 * star);
}
