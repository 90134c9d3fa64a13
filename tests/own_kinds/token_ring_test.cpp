// Tests a device that is defined only here. The token ring carries channels between the workstations in its slots. It
// must be read, checked, printed, run, reported, traced, drawn and broken like PlacedPar's own devices.

#include "app/program.hpp"
#include "explore/netlist_run.hpp"
#include "explore/problems.hpp"
#include "netlist/print/print.hpp"
#include "netlist/read.hpp"
#include "report/kinds_report.hpp"
#include "report/run_report.hpp"
#include "tests/own_kinds/token_ring.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

/// Returns the catalogue, made once for all tests of this program.
Catalogue catalogue_with_ring() {
    static const bool known = (add_own_devices({token_ring()}), true);
    REQUIRE(known);
    return known_kinds(known_problems(1));
}

/// Each station sends packets to the next one, as many and as fast as it can.
std::string all_send(std::size_t stations, const std::string& ring = "", const std::string& more = "") {
    return fmt::format("RING {1} r; workstation w[{0}];\n"
                       "rep i = 0 for {0} connect w[i].bus[0] to r.slot[i + 1];\n"
                       "process p[{0}], c[{0}];\n"
                       "use \"csp.producer\" for p; use \"csp.consumer\" for c;\n"
                       "rep i = 0 for {0} {{\n"
                       "    p[i] (count = 50, bytes = 1000); c[i] (count = 50);\n"
                       "    place p[i] on w[i]; place c[i] on w[(i + 1) % {0}];\n"
                       "    connect p[i].out to c[i].in;\n"
                       "}}\n{2}",
                       stations, ring, more);
}

Network network_of(const std::string& text) {
    ReadResult result = read_netlist_text(text, catalogue_with_ring());
    CAPTURE(render(result));
    REQUIRE(result.network);
    return std::move(*result.network);
}

std::string refusal_of(const std::string& text) {
    ReadResult result = read_netlist_text(text, catalogue_with_ring());
    REQUIRE(!result.diagnostics.empty());
    return result.diagnostics.front().message;
}

RunReport run(const Network& network) { return run_netlist(network, catalogue_with_ring(), RunSettings{}); }

/// Returns how long a frame with this many bytes takes at 4 Mbit/s.
constexpr Time frame_of(std::int64_t bytes) { return std::chrono::microseconds{2 * (bytes + 21)}; }

std::string contents(const std::filesystem::path& path) {
    std::stringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// Returns the exit code of a program with these arguments and its own devices.
int program(std::vector<std::string> arguments, std::vector<DeviceKind> devices = {}) {
    catalogue_with_ring();
    arguments.insert(arguments.begin(), "own_device");
    std::vector<char*> argv;
    for (std::string& each : arguments)
        argv.push_back(each.data());
    argv.push_back(nullptr);
    return run_program(static_cast<int>(arguments.size()), argv.data(), {}, {}, {}, std::move(devices));
}

} // namespace

TEST_CASE("where all stations of a token ring always send, its use is T / (T + hop)") {
    // W. Stallings, "Data and Computer Communications": 1 / (1 + a / N), where a is the time of a round of the token in
    // frames, and N the number of stations.
    for (std::size_t stations : {2, 3, 8})
        for (std::int64_t hop : {1, 1000, 100'000}) {
            RunReport report = run(network_of(all_send(stations, fmt::format("(hop = {})", hop))));
            CAPTURE(stations);
            CAPTURE(hop);
            CHECK(report.result.ending == Ending::completed);
            const auto frames = static_cast<std::int64_t>(50 * stations);
            const Time each = frame_of(1000), pass = std::chrono::nanoseconds{hop};
            CHECK(report.result.time == frames * (each + pass));
            REQUIRE(report.devices.size() == 1);
            CHECK(report.devices[0].busy == frames * each);
            CHECK(report.share(report.devices[0].busy).value() ==
                  doctest::Approx(1 / (1 + static_cast<double>(pass.count()) / static_cast<double>(each.count()))));
        }
}

TEST_CASE("a station that is alone waits for the token as long as it takes to come by") {
    // The token leaves w[3] at 0. w[1] sends from 2 us on, and w[2] receives. The token reaches w[1] again after 4
    // hops.
    Network network = network_of("RING r; workstation w[4]; rep i = 0 for 4 connect w[i].bus[0] to r.slot[2 * i + 1];\n"
                                 "process p, c; use \"csp.producer\" for p; use \"csp.consumer\" for c;\n"
                                 "p (count = 2, bytes = 5000); c (count = 2); place p on w[1]; place c on w[2];\n"
                                 "connect p.out to c.in;");
    RunReport report = run(network);
    const Time hop = std::chrono::microseconds{1};
    // Two frames for each packet, since one carries no more than 4096 bytes.
    CHECK(report.result.time == 2 * (frame_of(4096) + frame_of(904)) + (2 + 3 * 4) * hop);
    const DeviceUse& ring = report.devices.at(0);
    CHECK(ring.rows.at(1).name == "w[1]");
    CHECK(std::get<std::uint64_t>(ring.rows.at(1).figures.at(0)) == 4);
    CHECK(std::get<std::uint64_t>(ring.rows.at(1).figures.at(1)) == 10'000);
    CHECK(std::get<Time>(ring.rows.at(1).figures.at(2)) == (2 + 3 * 4) * hop);
    std::string text = print_report(report, network);
    CHECK(text.find("\nring r, busy 99.9%\nstation     frames      bytes    waiting\nw[0]     ") != std::string::npos);
    CHECK(text.find("\nw[1]             4      10000       0.1%\n") != std::string::npos);
}

TEST_CASE("a ring is described, printed and read again as any device") {
    Catalogue catalogue = catalogue_with_ring();
    CHECK(print_kind(catalogue, "RING").find("A token ring with slot[1] to slot[8]") != std::string::npos);
    Network network = network_of(all_send(3, "(bitrate = 16M)"));
    std::string printed = print_cfs(network);
    CHECK(printed.find("RING (bitrate = 16000000) r;") != std::string::npos);
    CHECK(network_of(printed).hash == network.hash);
    CHECK(print_json(network).find("\"kind\":\"token ring\",\"bits_per_second\":16000000") != std::string::npos);
    CHECK(print_dot(network).find("RING") != std::string::npos);
}

TEST_CASE("what does not fit on a ring is refused in its own words") {
    const std::string ring = "RING r; workstation a, b; C012 x; connect a.bus[0] to r.slot[1];\n";
    CHECK(refusal_of(ring + "connect x.bus[0] to r.slot[2]; connect b.bus[0] to r.slot[3];") ==
          "\"x\" cannot be a station of a ring");
    CHECK(refusal_of(ring + "connect b.bus[0] to r.slot[1];") == "two stations are in slot 1 of \"r\"");
    CHECK(refusal_of(ring + "connect b.bus[0] to r.slot[9];") == "the subscript 9 is outside of \"slot\"");
    CHECK(refusal_of(ring + "process p; place p on r;") == "\"r\" is a ring: no process can be placed on it");
    CHECK(refusal_of(ring + "process (interface (output out)) p; place p.out on r;") ==
          "\"r\" is a ring: a channel cannot be placed on the whole device");
    CHECK(refusal_of(ring + "fault r hogged;") == "a ring has no fault \"hogged\"");
}

TEST_CASE("a ring that breaks stops the channels that wait for its token") {
    Network network = network_of(all_send(3, "", "fault r breaks (from = 10ms);"));
    RunReport report = run(network);
    CHECK(report.result.ending == Ending::stuck);
    REQUIRE(report.faults.size() == 1);
    CHECK(report.faults[0].fault == "r breaks (from = 10ms)");
    CHECK(report.faults[0].stopped_channels.size() == 3);
    CHECK(report.faults[0].had_effect());
}

TEST_CASE("a program with a device of its own checks, runs, traces and draws it") {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "placedpar_token_ring";
    std::filesystem::create_directories(folder);
    auto file = [&](const char* name) { return (folder / name).string(); };
    std::ofstream(file("ring.cfs")) << all_send(3);
    CHECK(program({"check", file("ring.cfs")}) == 0);
    CHECK(program({"run", file("ring.cfs"), "--json", file("r.json"), "--trace", file("t.json"), "--page",
                   file("p.html")}) == 0);
    CHECK(contents(file("r.json")).find("\"title\": \"ring r\"") != std::string::npos);
    for (const char* station : {"w[0]", "w[2]"}) {
        CHECK(contents(file("t.json")).find(fmt::format("r <- {}", station)) != std::string::npos);
        CHECK(contents(file("p.html")).find(fmt::format("r \\u003c- {}", station)) != std::string::npos);
    }
    CHECK(contents(file("t.json")).find("waits for the token") != std::string::npos);
    CHECK(program({"show", file("ring.cfs"), "--format", "svg", "--out", file("s.svg")}) == 0);
    CHECK(program({"check", file("ring.cfs")}, {token_ring()}) == 1); // that name is taken
    std::filesystem::remove_all(folder);
}
