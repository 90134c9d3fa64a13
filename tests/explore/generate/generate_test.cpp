#include "explore/generate/generate.hpp"
#include "explore/generate/topology.hpp"
#include "explore/problems.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/kinds/environment.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "runtime/parallel.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

using namespace placedpar;
using generate::TopologyRequest;

namespace {

/// The known properties of a topology, from textbooks.
struct KnownMachine {
    TopologyRequest request;
    std::size_t processors, links, degree, diameter;
};

TopologyRequest sized(const std::string& topology, const std::string& size) {
    TopologyRequest request;
    request.topology = topology;
    request.size = size;
    return request;
}

std::string by(std::size_t rows, std::size_t columns) { return std::to_string(rows) + "x" + std::to_string(columns); }

std::vector<KnownMachine> lines_and_rings() {
    std::vector<KnownMachine> known;
    for (std::size_t n : {1U, 2U, 3U, 10U})
        known.push_back({sized("pipeline", std::to_string(n)), n, n - 1, n > 2 ? 2 : n - 1, n - 1});
    for (std::size_t n : {3U, 4U, 9U, 12U})
        known.push_back({sized("ring", std::to_string(n)), n, n, 2, n / 2});
    for (std::size_t n : {1U, 2U, 3U, 4U, 5U})
        known.push_back({sized("star", std::to_string(n)), n, n - 1, n - 1, n > 2 ? 2 : n - 1});
    return known;
}

/// Returns the number of wires of a row of processors. A row of more than two processors is closed into a ring.
std::size_t closed(std::size_t length) { return length > 2 ? length : length - 1; }
std::size_t links_across(std::size_t length) { return length > 2 ? 2 : length - 1; }

std::vector<KnownMachine> grids() {
    std::vector<KnownMachine> known;
    for (std::size_t r : {1U, 2U, 3U, 5U})
        for (std::size_t c : {1U, 2U, 4U})
            known.push_back({sized("mesh", by(r, c)), r * c, r * (c - 1) + c * (r - 1),
                             links_across(r) + links_across(c), r + c - 2});
    for (std::size_t r : {2U, 3U, 4U})
        for (std::size_t c : {2U, 3U, 5U}) {
            TopologyRequest request = sized("torus", by(r, c));
            request.host = "node";
            known.push_back(
                {request, r * c, r * closed(c) + c * closed(r), links_across(r) + links_across(c), r / 2 + c / 2});
        }
    for (std::size_t clusters : {1U, 2U, 3U, 4U})
        for (std::size_t length : {1U, 3U, 4U})
            known.push_back({sized("figure-e2", by(clusters, length)), clusters * length,
                             closed(clusters) + clusters * (length - 1),
                             std::max(links_across(clusters) + (length > 1), std::size_t{length > 2 ? 2U : 0U}),
                             clusters / 2 + (clusters > 1 ? 2 : 1) * (length - 1)});
    return known;
}

/// Returns meshes of three dimensions, each of whose nodes is two processors. Diameters were computed from the wires by
/// another program.
std::vector<KnownMachine> boxes() {
    struct Box {
        std::size_t planes, rows, columns, degree, diameter;
    };
    std::vector<KnownMachine> known;
    for (const auto& [p, r, c, degree, diameter] :
         {Box{1, 1, 1, 1, 1}, Box{1, 1, 2, 2, 3}, Box{1, 4, 1, 2, 7}, Box{4, 1, 1, 3, 5}, Box{2, 3, 4, 4, 9}})
        known.push_back({sized("mesh", std::to_string(p) + "x" + by(r, c)), 2 * p * r * c,
                         p * r * c + p * r * (c - 1) + p * (r - 1) * c + (p - 1) * r * c, degree, diameter});
    return known;
}

std::vector<KnownMachine> trees() {
    std::vector<KnownMachine> known{{sized("tree", "1"), 1, 0, 0, 0},    {sized("tree", "3"), 3, 2, 2, 2},
                                    {sized("tree", "7"), 7, 6, 3, 4},    {sized("tree", "10"), 10, 9, 3, 5},
                                    {sized("tree", "15"), 15, 14, 3, 6}, {sized("tree", "31"), 31, 30, 3, 8},
                                    {sized("tree", "13"), 13, 12, 4, 4}, {sized("tree", "6"), 6, 5, 2, 5}};
    known[6].request.branches = 3;
    known[7].request.branches = 1;
    return known;
}

std::vector<KnownMachine> cubes() {
    std::vector<KnownMachine> known;
    for (std::size_t d : {0U, 1U, 2U, 3U, 4U}) {
        known.push_back({sized("hypercube", std::to_string(1 << d)), std::size_t{1} << d, (d << d) / 2, d, d});
        known.back().request.host = "node";
    }
    known.push_back({sized("cube-connected-cycles", "24"), 24, 36, 3, 6});
    for (std::size_t d : {4U, 5U})
        known.push_back({sized("cube-connected-cycles", std::to_string(d << d)), d << d, 3 * (d << d) / 2, 3,
                         2 * d + d / 2 - 2}); // Friš, Havel, Liebl, 1997
    return known;
}

/// Returns known chordal rings. With three links for each processor: K3,3, the cube, the graphs of Heawood, Franklin,
/// and Moebius and Kantor, and F26A. With four links: the densest ring of each diameter (Boesch, Wang, 1985).
std::vector<KnownMachine> chordal_rings() {
    std::vector<KnownMachine> known;
    struct Three {
        std::size_t nodes, chord, diameter;
    };
    for (Three each : {Three{6, 3, 2}, {8, 3, 3}, {14, 5, 3}, {12, 5, 3}, {16, 5, 4}, {26, 7, 5}}) {
        known.push_back(
            {sized("chordal-ring", std::to_string(each.nodes)), each.nodes, each.nodes * 3 / 2, 3, each.diameter});
        known.back().request.chord = each.chord;
    }
    for (std::size_t k : {2U, 3U, 4U}) {
        std::size_t nodes = 2 * k * k + 2 * k + 1;
        known.push_back({sized("chordal-ring", std::to_string(nodes)), nodes, 2 * nodes, 4, k});
        known.back().request.degree = 4;
        known.back().request.chord = 2 * k + 1;
        known.back().request.host = "node";
    }
    return known;
}

std::vector<KnownMachine> all_known() {
    std::vector<KnownMachine> all;
    for (const auto& some : {lines_and_rings(), grids(), boxes(), trees(), cubes(), chordal_rings()})
        all.insert(all.end(), some.begin(), some.end());
    return all;
}

/// The process sends its number to each neighbour and receives the numbers of all neighbours.
void exchange_numbers(ProcessEnvironment& environment) {
    auto inputs = environment.inputs<int>("in");
    auto outputs = environment.outputs<int>("out");
    std::set<int> heard;
    auto number = static_cast<int>(environment.index());
    par_for(inputs.size() + outputs.size(), [&](std::size_t i) {
        if (i < inputs.size())
            heard.insert(inputs[i].input());
        else
            outputs[i - inputs.size()].output(number);
    });
    environment.measure("heard", static_cast<double>(heard.size()), "");
}

ProcessKind exchanger() {
    using namespace description;
    return {.name = "test.exchanger",
            .about = "",
            .ports = {optional(input<int>("in", "number", "")), optional(output<int>("out", "number", ""))},
            .measurements = {{"heard", "", ""}},
            .body = exchange_numbers};
}

RunReport run(const std::string& text, const Catalogue& catalogue, const Overrides& overrides) {
    ReadResult read = read_netlist_text(text, catalogue, overrides);
    CHECK_MESSAGE(render(read) == "", text);
    REQUIRE(read.network);
    Machine machine(*read.network, catalogue, 1);
    return machine.run(Time::max());
}

std::string refusal_of(const TopologyRequest& request) {
    ProblemRegistry problems = known_problems(1);
    try {
        generate::generate(request, known_kinds(problems));
    } catch (const UserError& refused) {
        return refused.what();
    }
    return "";
}

bool says(const TopologyRequest& request, const std::string& reason) {
    return refusal_of(request).find(reason) != std::string::npos;
}

} // namespace

TEST_CASE("every topology has its known number of processors and links, degree and diameter") {
    ProblemRegistry problems = known_problems(1);
    Catalogue catalogue = known_kinds(problems);
    for (const KnownMachine& known : all_known()) {
        INFO(known.request.topology << " " << known.request.size);
        generate::Distances found = generate::generate(known.request, catalogue).distances;
        CHECK(found.processors == known.processors);
        CHECK(found.links == known.links);
        CHECK(found.degree == known.degree);
        CHECK(found.diameter == known.diameter);
        CHECK(found.connected);
    }
}

TEST_CASE("a farm and islands run to their end on every topology, at several sizes") {
    ProblemRegistry problems = known_problems(1);
    Catalogue catalogue = known_kinds(problems);
    for (KnownMachine known : all_known())
        for (const char* job : {"farm", "islands"}) {
            INFO(known.request.topology << " " << known.request.size << " " << job);
            known.request.job = job;
            std::string text = generate::generate(known.request, catalogue).text;
            CHECK(text.size() < 4000); // replicators, not thousands of lines
            CHECK(run(text, catalogue, {{"samples", "5"}}).result.ending == Ending::completed);
        }
}

TEST_CASE("processes of a user's kind are connected along every wire and receive from each neighbour") {
    Catalogue catalogue;
    catalogue.add(exchanger());
    for (KnownMachine known : all_known()) {
        INFO(known.request.topology << " " << known.request.size);
        known.request.job = "test.exchanger";
        known.request.input = "in";
        known.request.output = "out";
        RunReport report = run(generate::generate(known.request, catalogue).text, catalogue, {});
        CHECK(report.result.ending == Ending::completed);
        double heard = 0;
        for (const auto& each : report.measurements)
            heard += std::get<double>(each.value);
        CHECK(heard == 2 * static_cast<double>(known.links));
    }
}

TEST_CASE("changing a val changes the size of a generated netlist") {
    ProblemRegistry problems = known_problems(1);
    Catalogue catalogue = known_kinds(problems);
    for (const char* job : {"farm", "islands"}) {
        TopologyRequest request = sized("mesh", "2x2");
        request.job = job;
        std::string text = generate::generate(request, catalogue).text;
        request.size = "3x4";
        std::string larger = generate::generate(request, catalogue).text;
        CHECK(run(text, catalogue, {{"rows", "3"}, {"columns", "4"}, {"samples", "5"}}).result.time ==
              run(larger, catalogue, {{"samples", "5"}}).result.time);
    }
}

TEST_CASE("a topology that needs more than four links of a processor is refused with the reason") {
    for (auto [topology, size] : {std::pair("torus", "3x3"), {"torus", "4x4"}, {"hypercube", "16"}})
        CHECK(says(sized(topology, size), "so no link is left for a wire to the host; --host node"));
    CHECK(says(sized("hypercube", "32"), "every processor needs 5 links, but a transputer has 4 links"));
    CHECK(says(sized("star", "6"), "its centre needs 5 links, but a transputer has 4 links"));
    TopologyRequest request = sized("tree", "9");
    request.branches = 4;
    CHECK(says(request, "needs 5 links, but a transputer has 4 links"));
    request = sized("chordal-ring", "12");
    request.degree = 4;
    CHECK(says(request, "so no link is left"));
    request.degree = 5;
    CHECK(says(request, "expected 3 or 4 links for each processor"));
}

TEST_CASE("sizes that a topology does not have are refused, with the reason") {
    for (const std::string& topology : generate::names_of_topologies())
        for (const char* size :
             {"0", "-1", "x", "4x", "x4", "0x4", "4x0", "4x4x4x4", "1.5", "8 ", "99999999999999999999", "99999999999",
              "4294967296x4294967296", "1e3", "0x10000000000000001"}) {
            INFO(topology << " " << size);
            CHECK(says(sized(topology, size), "of size " + std::string(size) + ": "));
        }
    CHECK(says(sized("ring", ""), "--size is required for the topology ring"));
    CHECK(says(sized("ring", "2"), "from 3 to 4096"));
    CHECK(says(sized("torus", "2x2x2"), "a node of three dimensions needs six links, but a transputer has 4"));
    CHECK(says(sized("mesh", "2x0x2"), "expected three numbers of at least 1, such as 2x3x4"));
    CHECK(says(sized("ring", "4097"), "at most 4096"));
    CHECK(says(sized("mesh", "1024x1024"), "at most 4096"));
    CHECK(says(sized("mesh", "16"), "expected two numbers"));
    CHECK(says(sized("hypercube", "12"), "a power of two, such as 8 or 16"));
    CHECK(says(sized("cube-connected-cycles", "25"), "24, 64, 160"));
    CHECK(says(sized("chordal-ring", "15"), "even"));
    for (std::size_t chord : {0U, 1U, 15U, 16U, 99U}) {
        TopologyRequest request = sized("chordal-ring", "16");
        request.chord = chord;
        CHECK(says(request, "leads to a neighbour or around the whole ring"));
    }
}

TEST_CASE("a machine whose routes are too long is refused with the size that it would have") {
    auto with_host_node = [](const std::string& topology, const std::string& size) {
        TopologyRequest request = sized(topology, size);
        request.host = "node";
        return request;
    };
    CHECK(refusal_of(with_host_node("ring", "1000")) == "");
    CHECK(refusal_of(with_host_node("ring", "1189")) == "");
    CHECK(refusal_of(with_host_node("ring", "1300")) ==
          "ring of size 1300: its channels pass through too many processors: written out it would have 20051793 "
          "bytes, but at most 16777216 bytes are allowed; choose a smaller size, or a topology of a smaller diameter");
    CHECK(refusal_of(with_host_node("torus", "64x64")) == "");
    CHECK(
        says(with_host_node("mesh", "2x2048"), "bytes, but at most 16777216 bytes are allowed; choose a smaller size"));
}

TEST_CASE("unknown topologies and jobs are refused with the known names") {
    CHECK(says(sized("moebius", "8"), "expected one of: pipeline, ring"));
    TopologyRequest request = sized("ring", "8");
    request.job = "ga.islnd";
    CHECK(says(request, "did you mean \"ga.island\"?"));
    request.job = "csp.identity";
    CHECK(says(request, "no output \"to_neighbours\""));
    request.job = "islands";
    request.branches = 2;
    CHECK(says(request, "--branches works only with the topology tree"));
}
