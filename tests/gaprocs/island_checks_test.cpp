// Tests which islands are refused before a run, and which place the message shows.

#include "gaprocs/processes/kinds.hpp"
#include "netlist/read.hpp"
#include "tests/gaprocs/line_problem.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// A channel from one island to another.
struct Way {
    int from, from_end, to, to_end;
};

/// Returns a netlist of islands with populations of 12 on one processor. The parameters are in line 4, and each channel
/// is in a line from 5 on.
std::string islands_netlist(int islands, const std::string& parameters, const std::vector<Way>& ways) {
    std::string text =
        fmt::format("val n {}; T800 t; workstation sun; connect sun.link[0] to t.link[0]; process host;\n"
                    "process island[n];\n"
                    "use \"ga.host\" for host; place host on sun; host (problem = \"line\");\n"
                    "{}\n",
                    islands, parameters);
    for (const Way& way : ways)
        text += fmt::format("connect island[{}].to_neighbours[{}] to island[{}].from_neighbours[{}];\n", way.from,
                            way.from_end, way.to, way.to_end);
    return text + "rep i = 0 for n { use \"ga.island\" for island[i]; place island[i] on t; "
                  "connect host.to_masters[i] to island[i].from_host; }\n";
}

std::string all(const std::string& more) { return "island (problem = \"line\", population = 12" + more + ");"; }

std::string said_of(const std::string& netlist) {
    ProblemRegistry problems;
    for (const char* name : {"line", "other line"})
        problems.add(name, make_search_problem(LineProblem{}), line_record(12));
    Catalogue catalogue;
    add_genetic_algorithm_kinds(catalogue, problems);
    return render(read_netlist_text(netlist, catalogue, {}, "islands.cfs").diagnostics);
}

std::string said_of(int islands, const std::string& parameters, const std::vector<Way>& ways) {
    return said_of(islands_netlist(islands, parameters, ways));
}

void check_says(const std::string& text, const std::string& part) {
    INFO(text);
    CHECK_MESSAGE(text.find(part) != std::string::npos, part);
}

std::vector<Way> ring(int islands) {
    std::vector<Way> ways;
    for (int i = 0; i < islands; ++i)
        ways.push_back({i, 0, (i + 1) % islands, 0});
    return ways;
}

/// Returns channels between island 0 and every other island, in both directions.
std::vector<Way> star(int islands) {
    std::vector<Way> ways;
    for (int i = 1; i < islands; ++i) {
        ways.push_back({0, i - 1, i, 0});
        ways.push_back({i, 0, 0, i - 1});
    }
    return ways;
}

/// Returns the parameters of three islands: `first` for the first two, `last` for the last.
std::string and_of_the_last(const std::string& first, const std::string& last) {
    return fmt::format("rep i = 0 for 2 island[i] (problem = \"line\", {0}); island[2] ({1});", first, last);
}

} // namespace

TEST_CASE("the old names of an island's ports are refused with a hint to the new names") {
    auto text = said_of(islands_netlist(2, all(""), {}) + "connect island[0].ring_out to island[1].ring_in;\n");
    check_says(text, "hint: its name is now \"to_neighbours\"");
    check_says(text, "hint: its name is now \"from_neighbours\"");
}

TEST_CASE("rings are accepted, and so are islands that state topology = \"none\"") {
    CHECK(said_of(3, all(""), ring(3)).empty());
    CHECK(said_of(3, all(", topology = \"ring\""), ring(3)).empty());
    CHECK(said_of(3, all(", topology = \"none\""), {}).empty());
    CHECK(said_of(2,
                  all(", schedule = \"sequential(every = 5)\", emigration = \"tournament(2, 3)\", acceptance = "
                      "\"offspring\""),
                  ring(2))
              .empty());
    CHECK(said_of(3, "island (problem = \"line\", population = 13, elite = 2);", ring(3)).empty()); // odd
}

TEST_CASE("populations of 0 and 1 are out of range") {
    auto said = [](int population) {
        return said_of(3, fmt::format("island (problem = \"line\", population = {});", population), ring(3));
    };
    check_says(said(0), "islands.cfs:4:27: error: the parameter \"population\" is out of range: 0 individuals");
    check_says(said(1), "islands.cfs:4:27: error: the parameter \"population\" is out of range: 1 individual\n");
}

TEST_CASE("an island without neighbours is refused if other islands have neighbours") {
    auto text = said_of(3, all(""), {{0, 0, 1, 0}, {1, 0, 0, 0}});
    check_says(text, "islands.cfs:2:9: error: the island \"island[2]\" has no neighbours, but other islands have");
    check_says(text, "for a search that exchanges nothing, use ga.master");
}

TEST_CASE("a topology in several parts gives one warning") {
    auto text = said_of(4, all(""), {{0, 0, 1, 0}, {1, 0, 0, 0}, {2, 0, 3, 0}, {3, 0, 2, 0}});
    CHECK(text == "islands.cfs:2:9: warning: the islands form 2 groups that exchange nothing with each other: "
                  "island[0], island[1]; island[2], island[3]\n"
                  "    process island[n];\n"
                  "            ^\n");
}

TEST_CASE("a one-way chain gives one warning: the last island's individuals never reach the first island") {
    check_says(said_of(3, all(""), {{0, 0, 1, 0}, {0, 1, 2, 0}}), // a star in one direction
               "warning: no individual from \"island[1]\" ever reaches \"island[0]\"");
    auto text = said_of(3, all(""), {{0, 0, 1, 0}, {1, 0, 2, 0}});
    CHECK(text == "islands.cfs:2:9: warning: no individual from \"island[1]\" ever reaches \"island[0]\"\n"
                  "    process island[n];\n"
                  "            ^\n"
                  "hint: to close a ring, connect the last island to the first\n");
}

TEST_CASE("islands without connections give one warning, unless they have topology = \"none\"") {
    auto said =
        "islands.cfs:2:9: warning: none of the 3 islands is connected to another, so they exchange nothing\n"
        "    process island[n];\n"
        "            ^\n"
        "hint: connect to_neighbours[0] of each island; for searches without exchange, set topology = \"none\"\n";
    CHECK(said_of(3, all(""), {}) == said);
    CHECK(said_of(3, all(", topology = \"none\""), {}).empty());
    CHECK(said_of(1, all(""), {}).empty());
}

TEST_CASE("islands whose run ends before the first exchange give one warning") {
    // There are 12 samples, with 5 generations each from the fifth sample on: 40 generations.
    CHECK(said_of(3, all(", exchange_every = 40"), ring(3)).empty());
    CHECK(said_of(3, all(", exchange_every = 41"), ring(3)) ==
          "islands.cfs:4:44: warning: \"island[0]\" never exchanges individuals: the first exchange is due after 41 "
          "generations, but the run has only 40\n"
          "    island (problem = \"line\", population = 12, exchange_every = 41);\n"
          "                                               ^\n");
    check_says(said_of(3, all(", schedule = \"sequential(41)\""), ring(3)), "islands.cfs:4:44: warning: \"island[0]\"");
    CHECK(said_of(3, all(", exchange_every = 41, topology = \"none\""), {}).empty());
    // Islands in step wait for the island that needs the most samples. Asynchronous islands do not.
    auto last = [](const std::string& every, const std::string& other) {
        return said_of(3, and_of_the_last(every, "problem = \"line\", first_window = 10, " + other), ring(3));
    };
    CHECK(last("exchange_every = 15", "exchange_every = 15").empty());
    check_says(last("exchange_every = 16", "exchange_every = 16"), "after 16 generations, but the run has only 15");
    std::string by_mail = last("schedule = \"asynchronous(16)\"", "schedule = \"asynchronous(16)\"");
    check_says(by_mail, "warning: \"island[2]\" never exchanges");
    CHECK(by_mail.find("\"island[0]\"") == std::string::npos);
}

TEST_CASE("connections that no topology can have are refused at their place") {
    check_says(said_of(2, all(""), {{0, 0, 1, 0}, {1, 0, 1, 1}}),
               "islands.cfs:6:1: error: \"island[1]\" is its own neighbour, expected another island");
    check_says(said_of(2, all(""), {{0, 0, 1, 0}, {0, 1, 1, 1}}),
               "error: \"island[0]\" is connected to \"island[1]\" twice, expected once");
}

TEST_CASE("connections that disagree with the parameter `topology` are refused") {
    check_says(said_of(12, all(", topology = \"hypercube\""), ring(12)),
               "islands.cfs:4:44: error: a hypercube cannot have 12 islands, expected a power of two such as 8 or 16");
    check_says(said_of(4, all(", topology = \"hypercube\""), ring(4)),
               "islands.cfs:4:44: error: \"island[0]\" is connected to island[1], expected island[1], island[2] in the "
               "topology \"hypercube\" of 4 islands");
    check_says(said_of(3, all(", topology = \"none\""), ring(3)), "expected no island in the topology");
    check_says(said_of(3, all(", topology = \"cube\""), ring(3)), "\"cube\" is not one of ring(ways = 1)");
    check_says(said_of(10, all(", topology = \"torus(3)\""), ring(10)), "expected a divisor of 10: 1, 2, 5, 10");
}

TEST_CASE("more emigrants than individuals, than a message can hold or than an island can accept are refused") {
    check_says(said_of(2, all(", emigration = \"best(13)\""), ring(2)),
               "islands.cfs:4:44: error: 13 emigrants cannot leave a population of 12, expected at most 12");
    check_says(said_of(2,
                       "island (problem = \"line\", population = 100000, emigration = \"best(50000)\", "
                       "string_bytes = 65536);",
                       ring(2)),
               "islands.cfs:4:48: error: a message for 50000 individuals would have");
    auto text = said_of(14, all(", elite = 1"), star(14));
    check_says(
        text,
        "islands.cfs:4:27: error: 13 immigrants come in one exchange to an island of 12 individuals with an elite "
        "of 1; expected at most 11");
    CHECK(said_of(12, all(", elite = 1"), star(12)).empty());
    auto no_pair = said_of(3, all(", elite = 11"), ring(3)); // a wrong elite gives no further message about immigrants
    check_says(no_pair, "an elite of 11 in a population of 12 leaves no pair");
    CHECK(no_pair.find("in one exchange") == std::string::npos);
    check_says(said_of(12, all(", elite = 1, schedule = \"sequential\", emigration = \"random(2)\""), star(12)),
               "22 immigrants come in one exchange");
}

TEST_CASE("an interval that is given both in the schedule and in exchange_every is refused") {
    check_says(said_of(2, all(", schedule = \"sequential(5)\", exchange_every = 5"), ring(2)),
               "error: exchange_every = 5, but the schedule \"sequential(5)\" states an interval, too");
    check_says(said_of(2, all(", schedule = \"sequential(0)\""), ring(2)), "every is a whole number from 1");
}

TEST_CASE("islands that could wait for each other for ever, or have different problems, are refused") {
    auto last = [](const std::string& first, const std::string& other) {
        return said_of(3, and_of_the_last(first, other), ring(3));
    };
    check_says(last("exchange_every = 3", "problem = \"line\", exchange_every = 4"),
               "error: the schedule of \"island[2]\" is broadcast(every = 4), but the schedule of \"island[0]\" is "
               "broadcast(every = 3)");
    check_says(last("trials = 5", "problem = \"line\", schedule = \"asynchronous\""),
               "error: the schedule of \"island[2]\" is asynchronous(every = 3), but");
    check_says(last("trials = 5", "problem = \"line\", trials = 4"),
               "error: \"trials\" is 4 generations per sample for \"island[2]\", but 5 for \"island[0]\"");
    check_says(last("trials = 5", "problem = \"line\", coding = \"gray\""),
               "error: coding = \"gray\" for \"island[2]\", but \"natural\" for \"island[0]\"");
    check_says(last("trials = 5", "problem = \"other line\""), "works on the problem");
    CHECK(last("schedule = \"asynchronous(3)\"", "problem = \"line\", schedule = \"asynchronous(4)\", trials = 4")
              .empty());
}

TEST_CASE("islands in step that are sent different numbers of samples are refused") {
    std::string text = "T800 a; workstation sun; connect sun.link[0] to a.link[0]; process host, hosts, i, j;\n"
                       "use \"ga.host\" for host; use \"ga.host\" for hosts; use \"ga.island\" for i; "
                       "use \"ga.island\" for j; place host on sun; place hosts on sun; place i on a; place j on a;\n"
                       "host (problem = \"line\"); hosts (problem = \"line\", samples = 11);\n"
                       "i (problem = \"line\"); j (problem = \"line\");\n"
                       "connect host.to_masters[0] to i.from_host; connect hosts.to_masters[0] to j.from_host;\n"
                       "connect i.to_neighbours[0] to j.from_neighbours[0]; "
                       "connect j.to_neighbours[0] to i.from_neighbours[0];\n";
    check_says(said_of(text), "error: \"j\" and \"i\" are sent different numbers of samples: 11 and 12");
    text.replace(text.find("samples = 11"), 12, "samples = 12");
    CHECK(said_of(text).empty());
}
