// Tests networks in which processes of kinds and programs in a transputer's own code exchange messages.

#include "netlist/kinds/csp_kinds.hpp"
#include "netlist/kinds/description.hpp"
#include "netlist/machine.hpp"
#include "netlist/network/names.hpp"
#include "netlist/print/print.hpp"
#include "netlist/print/promela.hpp"
#include "netlist/read.hpp"
#include "netlist/repeated_run.hpp"
#include "runtime/transputer/assembler.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <unistd.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <variant>
#include <vector>

using namespace placedpar;

namespace {

/// Returns each byte that comes in by link 1, for ever.
constexpr const char* echo = "ajw 8\n"
                             "loop: ldlp 1; mint; ldnlp 5; ldc 1; in\n"
                             "ldlp 1; mint; ldnlp 1; ldc 1; out\n"
                             "j loop\n";

/// A bootable file that exists as long as the object. Only one exists at a time.
class BootableFile {
public:
    explicit BootableFile(const std::string& source) {
        const std::vector<std::uint8_t> code = transputer::assemble(source).bytes;
        REQUIRE_LT(code.size(), 256);
        std::ofstream out(path_, std::ios::binary);
        out.put(static_cast<char>(code.size()));
        for (const std::uint8_t each : code)
            out.put(static_cast<char>(each));
    }
    BootableFile(const BootableFile&) = delete;
    ~BootableFile() { std::filesystem::remove(path_); }
    std::string path() const { return path_.string(); }

private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / fmt::format("placedpar-own-code-{}.btl", ::getpid());
};

/// Adds the kinds NAME.out, which outputs the messages, and NAME.in, which inputs them and counts those that are equal.
template <class T>
void add_pair(Catalogue& catalogue, const std::string& name, const std::vector<T>& messages) {
    catalogue.add({.name = name + ".out",
                   .about = "",
                   .ports = {description::output<T>("out", name, "")},
                   .body = [messages](ProcessEnvironment& self) {
                       for (const T& each : messages)
                           self.output<T>("out").output(each);
                   }});
    catalogue.add({.name = name + ".in",
                   .about = "",
                   .ports = {description::input<T>("in", name, "")},
                   .measurements = {{"equal", "", ""}},
                   .body = [messages](ProcessEnvironment& self) {
                       double equal = 0;
                       for (const T& each : messages)
                           equal += self.input<T>("in").input() == each;
                       self.measure("equal", equal - static_cast<double>(messages.size()));
                   }});
}

struct Halt {
    bool operator==(const Halt&) const = default;
};

const std::vector<std::string> protocols = {"int",  "byte",  "bool",    "int16", "int64",
                                            "real", "array", "counted", "case"};

Catalogue kinds_with_bytes() {
    Catalogue catalogue;
    add_csp_kinds(catalogue);
    add_pair<std::int32_t>(catalogue, "int", {-1, 7, 0x12345678});
    add_pair<std::uint8_t>(catalogue, "byte", {0, 255});
    add_pair<bool>(catalogue, "bool", {true, false});
    add_pair<std::int16_t>(catalogue, "int16", {-300, 5});
    add_pair<std::int64_t>(catalogue, "int64", {-5, std::int64_t{1} << 40});
    add_pair<double>(catalogue, "real", {0.1, -1e300});
    add_pair<std::array<float, 3>>(catalogue, "array", {{1, 2, 3}});
    add_pair<std::vector<std::uint8_t>>(catalogue, "counted", {{1, 2, 3}, {}, std::vector<std::uint8_t>(300, 9)});
    add_pair<std::variant<std::int32_t, Halt, std::vector<std::int32_t>>>(catalogue, "case",
                                                                          {5, Halt{}, std::vector<std::int32_t>{1, 2}});
    return catalogue;
}

/// A root with a program, and a processor `a` at its link 1; with additional statements.
std::string beside_code(const BootableFile& file, const std::string& more) {
    return fmt::format(R"(T800 (memory = 2M) root, a;
        connect root.link[0] to host;
        connect root.link[1] to a.link[2];
        use "{}" for root; {})",
                       file.path(), more);
}

/// An output and an input of processes on `a`, both at the program.
std::string with_pair(const std::string& out, const std::string& in) {
    return fmt::format(R"(process out, in; use "{}" for out; use "{}" for in; place out on a; place in on a;
        place out.out on a.link[2]; place in.in on a.link[2];)",
                       out, in);
}

ReadResult read_mixed(const std::string& text, const std::vector<std::string>& faults = {}) {
    return read_netlist_text(text, kinds_with_bytes(), {}, "netlist", {.faults = faults});
}

Network mixed_network(const std::string& text, const std::vector<std::string>& faults = {}) {
    ReadResult read = read_mixed(text, faults);
    INFO(render(read));
    REQUIRE(read.network);
    return *read.network;
}

RunReport run_mixed(const std::string& text, const std::vector<std::string>& faults = {}) {
    const Catalogue kinds = kinds_with_bytes();
    return Machine(mixed_network(text, faults), kinds, 1).run();
}

} // namespace

TEST_CASE("messages of all protocols go to a transputer's own code and back") {
    const BootableFile file(echo);
    for (const std::string& protocol : protocols) {
        CAPTURE(protocol);
        const RunReport report = run_mixed(beside_code(file, with_pair(protocol + ".out", protocol + ".in")));
        CHECK_EQ(report.measured("in", "equal"), 0);
    }
}

TEST_CASE("a process on a workstation talks to a transputer's own code") {
    const BootableFile file(echo);
    const RunReport report = run_mixed(fmt::format(
        R"(T800 (memory = 2M) root; workstation desk; connect root.link[0] to host; connect desk.link[0] to root.link[1];
           use "{}" for root; process out, in; use "int.out" for out; use "int.in" for in;
           place out on desk; place in on desk; place out.out on desk.link[0]; place in.in on desk.link[0];)",
        file.path()));
    CHECK_EQ(report.measured("in", "equal"), 0);
}

TEST_CASE("bytes that are no message of the process's protocol end the run with their place") {
    const BootableFile file(echo);
    try {
        run_mixed(beside_code(file, with_pair("int.out", "counted.in"))); // the first integer is -1
        FAIL("no error");
    } catch (const UserError& refused) {
        const std::string why = refused.what();
        CAPTURE(why);
        CHECK(why.find("process in (counted.in)") != why.npos);
        CHECK(why.find("root sent something other than a message of channel root -> in.in: an array cannot have -1 "
                       "elements") != why.npos);
    }
}

TEST_CASE("a deadlock between a process and a transputer's own code names both") {
    const BootableFile file(echo);
    const RunReport report = run_mixed(beside_code(
        file, R"(process in; use "csp.consumer" for in; in (count = 1); place in on a; place in.in on a.link[2];)"));
    REQUIRE(report.result.ending == Ending::stuck);
    const std::string text = report.result.deadlock->text();
    CAPTURE(text);
    const StuckChannel* const stuck = find_named(report.result.deadlock->channels, "root -> in.in");
    REQUIRE(stuck);
    CHECK(stuck->outputter.starts_with("root.#"));
    CHECK_EQ(stuck->inputter, "in");
    CHECK_EQ(stuck->waiting, "inputter");
    CHECK(stuck->netlist.starts_with("netlist:"));
    CHECK(report.result.deadlock->cycle.empty());
}

TEST_CASE("a wait cycle leads over a process and a transputer's own code, whose channels have one name") {
    const BootableFile file(echo);
    const RunReport report = run_mixed(beside_code(file, R"(process id; use "csp.identity" for id; place id on a;
        place id.in on a.link[2]; place id.out on a.link[2];)"));
    REQUIRE(report.result.ending == Ending::stuck);
    const Deadlock& deadlock = *report.result.deadlock;
    CAPTURE(deadlock.text());
    REQUIRE_EQ(deadlock.cycle.size(), 2); // both input first
    CHECK(deadlock.cycle[0].starts_with("root.#"));
    CHECK_EQ(deadlock.cycle[1], "id");
    REQUIRE_EQ(deadlock.channels.size(), 2);
    for (const StuckChannel& each : deadlock.channels) {
        CHECK_EQ(each.waiting, "inputter");
        CHECK((each.name == "id.out -> root" || each.name == "root -> id.in"));
        CHECK_EQ(each.name == "id.out -> root" ? each.outputter : each.inputter, "id");
        CHECK((each.name == "id.out -> root" ? each.inputter : each.outputter).starts_with("root.#"));
        CHECK(each.netlist.starts_with("netlist:"));
    }
}

TEST_CASE("a fault of the wire stops a message to a transputer's own code, and names its channel") {
    const BootableFile file(echo);
    const RunReport report =
        run_mixed(beside_code(file, with_pair("int.out", "int.in")), {"a.link[2] silent (direction = \"out\")"});
    REQUIRE(report.result.ending == Ending::stuck);
    REQUIRE_EQ(report.faults.size(), 1);
    CHECK_EQ(report.faults[0].bytes_lost, 1);
    REQUIRE(report.faults[0].first);
    CHECK_EQ(report.faults[0].first->channel, "out.out -> root");
}

TEST_CASE("a network with own code beside processes is printed, read again, and cannot be repeated or modelled") {
    const BootableFile file(echo);
    const Network network = mixed_network(beside_code(file, R"(process p, c; use "csp.producer" for p;
        use "csp.consumer" for c; place p on a; place c on a; place p.out on a.link[2]; place c.in on a.link[2];)"));
    CHECK_EQ(mixed_network(print_cfs(network)).hash, network.hash);
    CHECK_FALSE(is_determinate(network, kinds_with_bytes()));
    CHECK_THROWS_WITH_AS(print_promela(network, kinds_with_bytes()),
                         "\"root\" executes its own code, which has no Promela model", UserError);
    CHECK(print_json(network).find(R"("to": {"node":"root"})") != std::string::npos);
}

TEST_CASE("a process gives up messages to a transputer's own code that does not take them") {
    const BootableFile file(echo);
    const std::string sender = R"(process p; use "csp.sender_or_fail" for p; p (count = 3); place p on a;
        place p.out on a.link[2];)";
    const RunReport alone = run_mixed(beside_code(file, sender)); // the program waits to return the first byte
    CHECK_EQ(alone.measured("p", "given_up"), 3);
    const RunReport both = run_mixed(beside_code(
        file,
        sender + R"(process c; use "csp.consumer" for c; c (count = 3); place c on a; place c.in on a.link[2];)"));
    CHECK_EQ(both.measured("p", "given_up"), 0);
    CHECK_EQ(both.measured("c", "last_number"), 2);
}
