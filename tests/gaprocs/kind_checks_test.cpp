// Tests which netlists the kinds refuse before a run, and which place the message shows.

#include "gaprocs/processes/kinds.hpp"
#include "gaprocs/processes/messages.hpp"
#include "gaprocs/processes/parameters.hpp"
#include "netlist/machine.hpp"
#include "netlist/read.hpp"
#include "tests/gaprocs/line_problem.hpp"
#include "tests/gaprocs/objectives.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <map>
#include <string>

using namespace placedpar;

namespace {

constexpr std::size_t samples = 12;

/// Returns the statements of a netlist with a host, a master and two slaves, by a name for each statement.
std::map<std::string, std::string> statements() {
    return {{"host", "host (problem = \"line\");"},
            {"master", "master (problem = \"line\", slaves = 2);"},
            {"slave 0", "slave[0] (problem = \"line\");"},
            {"slave 1", "slave[1] (problem = \"line\");"},
            {"to slaves", "connect master.to_slaves to slave[0].from_master;"},
            {"from slaves", "connect slave[0].to_master to master.from_slaves;"},
            {"to next", "connect slave[0].to_slaves to slave[1].from_master;"},
            {"from next", "connect slave[1].to_master to slave[0].from_slaves;"}};
}

/// Returns a netlist. Lines 1 to 8 are the statements, ordered by name. The other lines are the same for all netlists.
std::string netlist(const std::map<std::string, std::string>& lines) {
    std::string text = "T800 t; workstation sun; connect sun.link[0] to t.link[0]; process host; process master; "
                       "process slave[2]; use \"ga.host\" for host; use \"ga.master\" for master; "
                       "use \"ga.slave\" for slave[0]; use \"ga.slave\" for slave[1];\n";
    for (const auto& [name, statement] : lines)
        text += statement + "\n";
    return text + "connect host.to_masters[0] to master.from_host;\n"
                  "place host on sun; place master on t; place slave[0] on t; place slave[1] on t;\n";
}

struct Kinds {
    ProblemRegistry problems;
    Catalogue catalogue;

    Kinds() {
        problems.add("line", make_search_problem(LineProblem{}), line_record(samples));
        problems.add("other line", make_search_problem(LineProblem{}), line_record(samples));
        problems.add("along", make_search_problem(LineAlongWindow{}), line_record(samples));
        problems.add("sphere", minimise(PlainSphere{}));
        auto make = [] { return line_record(samples); };
        problems.add_to_make("timed", make_search_problem(LineProblem{}), {samples, make, {.trials = 3, .bias = 10}});
        add_genetic_algorithm_kinds(catalogue, problems);
    }
};

/// Returns all complaints about the netlist in which one of the statements() is replaced.
std::string refusal(const std::string& name, const std::string& statement) {
    Kinds kinds;
    auto lines = statements();
    lines.at(name) = statement;
    return render(read_netlist_text(netlist(lines), kinds.catalogue, {}, "farm.cfs").diagnostics);
}

std::string refusal_of(const std::map<std::string, std::string>& lines) {
    Kinds kinds;
    return render(read_netlist_text(netlist(lines), kinds.catalogue, {}, "farm.cfs").diagnostics);
}

bool says(const std::string& text, const std::string& part) {
    INFO(text);
    bool found = text.find(part) != std::string::npos;
    CHECK_MESSAGE(found, part);
    return found;
}

/// Returns statements that connect each slave directly to the master.
auto star_statements() {
    auto lines = statements();
    lines.at("to next") = "connect master.to_slaves[1] to slave[1].from_master;";
    lines.at("to slaves") = "connect master.to_slaves[0] to slave[0].from_master;";
    lines.at("from slaves") = "connect slave[0].to_master to master.from_slaves[0];";
    lines.at("from next") = "connect slave[1].to_master to master.from_slaves[1];";
    return lines;
}

} // namespace

TEST_CASE("a message shorter than the string that it carries gives a warning") {
    CHECK(refusal("master", "master (problem = \"line\", slaves = 2, string_bytes = 1);").empty());
    CHECK(refusal("master", "master (problem = \"line\", slaves = 2, coding = \"natural(1)\", string_bytes = 2);")
              .empty());
    auto said =
        refusal("master", "master (problem = \"line\", slaves = 2, coding = \"natural(1)\", string_bytes = 1);");
    CHECK(said.starts_with("farm.cfs:5:62: warning: string_bytes = 1, but a string of \"line\" has 2 bytes"));
}

TEST_CASE("settings that do not suit the record give one warning each") {
    auto lines = statements();
    for (auto& [name, statement] : lines)
        if (auto at = statement.find("line"); at != std::string::npos)
            statement.replace(at, 4, "timed");
    auto said_with = [&](const std::string& more) {
        lines["master"] = "master (problem = \"timed\", slaves = 2" + more + ");";
        return refusal_of(lines);
    };
    CHECK(said_with(", trials = 3, bias = 10").empty());
    CHECK(said_with(", trials = 3, bias = 400").empty()); // a bias that the netlist states gives no warning
    CHECK(said_with(", trials = 2, bias = 10") ==
          "farm.cfs:5:40: warning: trials = 2, but the record of \"timed\" has one sample for every 3 generations, so "
          "the changes in the record come at other generations than documented\n"
          "    master (problem = \"timed\", slaves = 2, trials = 2, bias = 10);\n"
          "                                           ^\n"
          "hint: trials = 3\n");
    std::string said = said_with("");
    CHECK(said.find("warning: trials = 5, but") != std::string::npos);
    CHECK(said.find("warning: bias = 400 was chosen for the problem \"boom\"") != std::string::npos);
    CHECK(said.find("hint: bias = 10\n") != std::string::npos);
}

TEST_CASE("the netlist that the other tests alter is accepted") {
    Kinds kinds;
    CHECK(render(read_netlist_text(netlist(statements()), kinds.catalogue).diagnostics).empty());
}

TEST_CASE("a port that is connected without its counterpart is refused at the connected port") {
    auto lines = statements();
    lines.at("from slaves") = "connect slave[0].to_master to slave[0].from_slaves;";
    lines.at("from next") = "connect slave[1].to_master to slave[1].from_slaves;";
    Kinds kinds;
    auto text = render(read_netlist_text(netlist(lines), kinds.catalogue, {}, "farm.cfs").diagnostics);
    says(text, "farm.cfs:9:1: error: the channel \"master.to_slaves\" is connected, but \"master.from_slaves\" is "
               "not\n    connect master.to_slaves");
    says(text, "hint: the kind \"ga.master\" needs both channels or neither: connect master.from_slaves to ...;");
    says(text,
         "farm.cfs:2:1: error: the channel \"slave[1].from_slaves\" is connected, but \"slave[1].to_slaves\" is not");
}

TEST_CASE("results that do not return to the process that sent the task are refused") {
    auto lines = statements();
    lines.at("from slaves") = "connect slave[1].to_master to master.from_slaves;";
    lines.at("from next") = "connect slave[0].to_master to slave[0].from_slaves;";
    Kinds kinds;
    auto text = render(read_netlist_text(netlist(lines), kinds.catalogue, {}, "farm.cfs").diagnostics);
    says(text, "farm.cfs:3:1: error: \"master.to_slaves\" leads to the slave \"slave[0]\", but "
               "\"master.from_slaves\" is connected to \"slave[1].to_master\"");
    says(text, "hint: connect slave[0].to_master to master.from_slaves;");
}

TEST_CASE("the old names of ports are refused with a hint to the new names") {
    auto text = refusal("to next", "connect slave[0].to_next to slave[1].from_master;");
    says(text, "error: the kind \"ga.slave\" of \"slave[0]\" has no channel \"to_next\"");
    says(text, "hint: its name is now \"to_slaves\"");
    says(refusal("from next", "connect slave[1].to_master to slave[0].from_next;"),
         "hint: its name is now \"from_slaves\"");
    const std::string interface = "process (interface (input from_master, output to_master, output to_next, input "
                                  "from_next)) older; use \"ga.slave\" for older; place older on t;";
    says(refusal("host", interface), "hint: its name is now \"to_slaves\"");
}

TEST_CASE("a number of slaves that differs from the chain's, or exceeds the work, is refused") {
    for (int slaves : {1, 3})
        says(refusal("master", fmt::format("master (problem = \"line\",\nslaves = {});", slaves)),
             fmt::format(
                 "farm.cfs:6:1: error: slaves = {}, but the number of slaves connected to \"master.to_slaves\" is 2",
                 slaves));
    says(refusal("master", "master (problem = \"line\", slaves = 2, population = 2);"),
         "farm.cfs:5:27: error: slaves = 2, but a population of 2 has work for at most 1 slave");
    CHECK(refusal("master", "master (problem = \"line\", slaves = 2, population = 3);").empty());
    CHECK(refusal("master", "master (problem = \"line\", slaves = 2, population = 2, own_share = 0);").empty());
}

TEST_CASE("a host that sends too few samples for the first generation is refused") {
    auto host = [](int sent) {
        auto lines = statements();
        lines.at("host") = fmt::format("host (problem = \"line\", samples = {});", sent);
        lines.at("master") = "master (problem = \"line\", slaves = 2,\nfirst_window = 6);";
        return refusal_of(lines);
    };
    says(host(5), "farm.cfs:6:1: error: the first generation waits for 6 samples, but \"host\" sends 5");
    CHECK(host(6).empty());
    CHECK(host(0).empty()); // 0 means all samples
}

TEST_CASE("a host need not send more samples than the window holds") {
    auto host = [](int sent) {
        auto lines = statements();
        lines.at("host") = fmt::format("host (problem = \"line\", samples = {});", sent);
        lines.at("master") = "master (problem = \"line\", slaves = 2, window = 3);";
        return refusal_of(lines);
    };
    says(host(2), "the first generation waits for 3 samples, but \"host\" sends 2");
    CHECK(host(3).empty());
}

TEST_CASE("a problem whose errors depend on earlier samples refuses the split into single evaluations") {
    auto text = refusal("master", "master (problem = \"along\", slaves = 2,\nsplit = \"evaluations\");");
    says(text, "farm.cfs:6:1: error: single evaluations of \"along\" cannot be dealt out: its error at a sample "
               "depends on the earlier samples in the window");
    says(text, "hint: split = \"individuals\" deals out whole individuals");
    for (const char* split : {"individuals", "demand"})
        CHECK(refusal("master", fmt::format("master (problem = \"along\", slaves = 2, split = \"{}\");", split))
                  .find("dealt out") == std::string::npos);
}

TEST_CASE("a slave that is reached twice is refused") {
    auto lines = statements();
    lines.at("to slaves") = "connect master.to_slaves[0] to slave[0].from_master[0];\n"
                            "connect master.to_slaves[1] to slave[0].from_master[1];";
    lines.at("from slaves") = "connect slave[0].to_master[0] to master.from_slaves[0];\n"
                              "connect slave[0].to_master[1] to master.from_slaves[1];";
    auto text = refusal_of(lines);
    says(text, "farm.cfs:11:1: error: \"master.to_slaves[1]\" leads to the slave \"slave[0]\", but "
               "\"master.to_slaves[0]\" leads to the same slave");
    says(text, "farm.cfs:10:1: error: \"slave[0].from_master\" must be a single channel, not an array: a slave is "
               "connected to one master or to one preceding slave");
    says(text, "hint: write slave[0].from_master without a subscript");
}

TEST_CASE("slaves in a circle, which no master reaches, are refused once") {
    auto lines = statements();
    lines.at("master") = "master (problem = \"line\");";
    lines.at("to slaves") = "connect slave[1].to_slaves to slave[0].from_master;";
    lines.at("from slaves") = "connect slave[0].to_master to slave[1].from_slaves;";
    auto text = refusal_of(lines);
    says(text, "farm.cfs:9:1: error: the slaves \"slave[1]\", \"slave[0]\" are connected in a circle, so no master's "
               "tasks reach them\n    connect slave[1].to_slaves");
    CHECK(text.find("circle", text.find("circle") + 1) == std::string::npos);
}

TEST_CASE("crossed, missing or unnumbered connections in a tree are refused") {
    auto lines = star_statements();
    CHECK(refusal_of(lines).empty());

    auto crossed = lines;
    crossed.at("from slaves") = "connect slave[0].to_master to master.from_slaves[1];";
    crossed.at("from next") = "connect slave[1].to_master to master.from_slaves[0];";
    says(refusal_of(crossed), "farm.cfs:2:1: error: \"master.to_slaves[0]\" leads to the slave \"slave[0]\", but "
                              "\"master.from_slaves[0]\" is connected to \"slave[1].to_master\"");

    auto elsewhere = lines;
    elsewhere.at("from next") = "connect slave[1].to_master to slave[1].from_slaves;";
    says(refusal_of(elsewhere), "the channel \"slave[1].from_slaves\" is connected, but \"slave[1].to_slaves\" is not");

    auto gap = lines; // ports that an interface declares may stay unconnected
    gap.at("to next") = "connect master.to_slaves[2] to slave[1].from_master;";
    gap.at("from next") = "connect slave[1].to_master to master.from_slaves[2];";
    std::string text = netlist(gap), declared = "process master;";
    text.replace(text.find(declared), declared.size(),
                 "process (interface (input from_host, output to_slaves[3], input from_slaves[3])) master;");
    Kinds kinds;
    auto said = render(read_netlist_text(text, kinds.catalogue, {}, "farm.cfs").diagnostics);
    says(said, "farm.cfs:8:1: error: \"master.to_slaves[2]\" is connected, but \"master.to_slaves[1]\" is not");
    says(said, "hint: the channels to_slaves[...] of a process must be numbered 0, 1, 2 ... without a gap");
}

TEST_CASE("a number of slaves that differs from the tree's is refused") {
    auto lines = star_statements();
    lines.at("master") = "master (problem = \"line\", slaves = 3);";
    says(refusal_of(lines),
         "farm.cfs:5:27: error: slaves = 3, but the number of slaves connected to \"master.to_slaves\" is 2");
}

TEST_CASE("several tasks under way are refused with a split other than demand") {
    says(refusal("master", "master (problem = \"line\", slaves = 2, tasks_under_way = 2);"),
         "farm.cfs:5:39: error: tasks_under_way = 2, but with the split \"individuals\" each slave is sent one task");
    CHECK(
        refusal("master", "master (problem = \"line\", slaves = 2, tasks_under_way = 2, split = \"demand\");").empty());
}

TEST_CASE("an array at a port that is a single channel is refused at its process") {
    Kinds kinds;
    std::string text = netlist(statements()), end = "to master.from_host;";
    text.replace(text.find(end), end.size(), "to master.from_host[0];");
    auto read = read_netlist_text(text, kinds.catalogue, {}, "farm.cfs");
    REQUIRE(read.network);
    CHECK_THROWS_WITH_AS(Machine(*read.network, kinds.catalogue, 1).run(),
                         doctest::Contains("process master (ga.master): \"from_host\" is a single channel of this "
                                           "kind, not an array: connect it without a subscript"),
                         UserError);
}

TEST_CASE("settings that contradict each other are refused at the parameter") {
    auto master = [](const char* settings) {
        return refusal("master", fmt::format("master (problem = \"line\", slaves = 2, {});", settings));
    };
    says(master("window = 13"),
         "farm.cfs:5:39: error: the window holds 13 samples, but the record of \"line\" has only 12");
    says(master("first_window = 4, window = 3"),
         "farm.cfs:5:39: error: the first generation waits for 4 samples, but the window holds 3");
    says(master("first_window = 11"), "the first generation waits for 11 samples, but the window holds 10");
    CHECK(master("window = 3").empty()); // first_window has a default, which is reduced to the window
    says(master("population = 10, elite = 9"),
         "farm.cfs:5:56: error: an elite of 9 in a population of 10 leaves no pair");
    says(master("bias = 8388609.0"), "expected from 1e-300 to 8388608");
    CHECK(master("bias = 8388608.0").empty());
    says(refusal("host", "host (samples = 13, problem = \"line\");"),
         "farm.cfs:4:7: error: samples = 13, but the record of \"line\" has only 12");
}

TEST_CASE("unknown problems, and different problems of a master and its slaves, are refused") {
    says(refusal("slave 0", "slave[0] (problem = \"curve\");"),
         "farm.cfs:6:11: error: unknown search problem 'curve'; known: along, line, other line, sphere");
    says(refusal("slave 1", "slave[1] (problem = \"other line\");"),
         "farm.cfs:7:11: error: \"slave[1]\" works on the problem \"other line\", but \"master\" works on \"line\"");
    says(refusal("host", "host (problem = \"other line\");"), "\"host\" works on the problem \"other line\"");
}

TEST_CASE("a problem that does not exist is refused once, at the first process that names it") {
    auto lines = statements();
    for (auto& [name, statement] : lines)
        for (auto at = statement.find("\"line\""); at != std::string::npos; at = std::string::npos)
            statement.replace(at, 6, "\"curve\"");
    Kinds kinds;
    auto read = read_netlist_text(netlist(lines), kinds.catalogue, {}, "farm.cfs");
    CHECK(read.diagnostics.size() == 1);
    says(render(read.diagnostics), "farm.cfs:4:7: error: unknown search problem 'curve'");
}

namespace {

/// Returns all complaints about the netlist in which all processes have the problem "sphere"; `host` and `master` are
/// further parameters.
std::string refusal_of_sphere(const std::string& host, const std::string& master) {
    auto lines = statements();
    lines.at("host") = fmt::format("host (problem = \"sphere\"{});", host);
    lines.at("master") = fmt::format("master (problem = \"sphere\", slaves = 2{});", master);
    lines.at("slave 0") = "slave[0] (problem = \"sphere\");";
    lines.at("slave 1") = "slave[1] (problem = \"sphere\");";
    Kinds kinds;
    return render(read_netlist_text(netlist(lines), kinds.catalogue, {}, "farm.cfs").diagnostics);
}

} // namespace

TEST_CASE("parameters that need a record are ignored, with a warning, for a problem without one") {
    CHECK(refusal_of_sphere("", "").empty());
    CHECK(refusal_of_sphere(", generations = 7", "").empty());
    for (const char* parameter :
         {"window = 10", "first_window = 5", "trials = 5", "bias = 400.0", "measurement_bytes = 148",
          "cycles_per_measurement_word = 0", "measurements = \"sample\""}) {
        std::string name(parameter, std::string(parameter).find(' '));
        says(refusal_of_sphere("", fmt::format(", {}", parameter)),
             fmt::format("farm.cfs:5:41: warning: the problem \"sphere\" has no record of measurements, so these "
                         "settings have no effect: {}\n",
                         name));
    }
    says(refusal_of_sphere(", samples = 3", ""), "farm.cfs:4:27: warning: the problem \"sphere\" has no record of "
                                                 "measurements, so these settings have no effect: samples\n");
    says(refusal_of_sphere(", sample_bytes = 3", ""), "hint: \"generations\" of ga.host sets the length of the search");
    says(refusal_of_sphere("", ", window = 10, bias = 400.0"), "have no effect: window, bias\n");
    says(refusal("host", "host (problem = \"line\", generations = 3);"),
         "farm.cfs:4:25: error: generations applies only to problems without a record: \"line\" has a record of 12 "
         "samples");
}

TEST_CASE("a reproduction that an objective does not allow is refused at its parameter") {
    says(refusal_of_sphere("", ", reproduction = \"roulette\""),
         "farm.cfs:5:41: error: reproduction by roulette discards individuals with fitness <= 0");
    CHECK(refusal_of_sphere("", ", reproduction = \"tournament\"").empty());
}

TEST_CASE("operators and codings that do not fit the strings are refused at their parameter, with those that fit") {
    says(refusal_of_sphere("", ", crossover_operator = \"order\""),
         "farm.cfs:5:41: error: the crossover \"order\" does not fit binary strings: expected one-point, two-point, "
         "uniform, by-difference");
    says(refusal_of_sphere("", ", mutation_operator = \"gaussian\""),
         "the mutation \"gaussian(deviation = 0.1)\" does not fit binary strings: expected bit");
    says(refusal_of_sphere("", ", coding = \"real\", crossover_operator = \"by-difference\""),
         "does not fit real vectors: expected one-point, two-point, uniform, blend, sbx");
    CHECK(refusal_of_sphere("", ", coding = \"real\"").empty());
    CHECK(refusal_of_sphere("", ", coding = \"real\", mutation_operator = \"breeder\"").empty());
    auto line = [](const char* given) {
        return refusal("master", fmt::format("master (problem = \"line\", slaves = 2, {});", given));
    };
    says(line("coding = \"real\""), "farm.cfs:5:39: error: the coding \"real\" has no meaning for this problem");
    says(line("coding = \"grey\""), "did you mean \"gray\"?");
    says(line("coding = \"gray(65)\""), "dont_care = 65 is out of range");
    says(line("mutation_operator = \"swap\""), "does not fit binary strings: expected bit");
    CHECK(line("coding = \"gray(dont_care = 2)\"").empty());
}

TEST_CASE("the length of a string in a message is as the netlist states, or else the string's bits in whole bytes") {
    auto problem = make_search_problem(LineProblem{});
    CHECK(string_bytes(0, *problem) == (problem->bits() + 7) / 8);
    CHECK(string_bytes(2, *problem) == 2);
    auto time_with = [](const std::string& stated) {
        auto lines = statements();
        lines.at("master") = "master (problem = \"line\", slaves = 2" + stated + ");";
        Kinds kinds;
        auto read = read_netlist_text(netlist(lines), kinds.catalogue, {}, "farm.cfs");
        REQUIRE(read.network);
        return Machine(*read.network, kinds.catalogue, 1).run().result.time;
    };
    CHECK(time_with("") == time_with(", string_bytes = 1"));
    CHECK(time_with("") < time_with(", string_bytes = 512"));
}

TEST_CASE("messages longer than a count of 31 bits can state are refused") {
    // 98304 individuals are divided into three shares of 32768. With 65536 bytes each, these have 2^31 bytes.
    auto strings = [](int population, int bytes) {
        return refusal("master", fmt::format("master (problem = \"line\", slaves = 2, measurement_bytes = 1, "
                                             "population = {}, string_bytes = {});",
                                             population, bytes));
    };
    says(strings(98304, 65536), "farm.cfs:5:82: error: a message for 32768 individuals would have 2147483649 bytes");
    says(strings(196608, 65536), "would have 4294967297 bytes"); // in 32 bits, this would be 1
    CHECK(strings(98301, 65536).empty());
    auto lines = statements();
    lines.at("master") = "master (problem = \"line\", slaves = 2, population = 98304);";
    lines.at("slave 1") = "slave[1] (problem = \"line\", fitness_bytes = 65536);";
    Kinds kinds;
    says(render(read_netlist_text(netlist(lines), kinds.catalogue, {}, "farm.cfs").diagnostics),
         "farm.cfs:7:29: error: a message for 32768 individuals would have 2147483648 bytes");
    CHECK(message_bytes(32767, 65536, 65535) == 0x7fffffff);
    CHECK_THROWS_AS(message_bytes(32767, 65536, 65536), UserError);
}

TEST_CASE("an error that is found only during the run names the process, its kind and its line") {
    Kinds kinds;
    auto read = read_netlist_text(netlist(statements()), kinds.catalogue, {}, "farm.cfs");
    REQUIRE(read.network);
    ProblemRegistry shorter; // its record is shorter than the one that was checked
    shorter.add("line", make_search_problem(LineProblem{}), line_record(9));
    Catalogue others;
    add_genetic_algorithm_kinds(others, shorter);
    CHECK_THROWS_WITH_AS(Machine(*read.network, others, 1).run(), doctest::Contains("farm.cfs:1:"), UserError);
    CHECK_THROWS_WITH_AS(
        Machine(*read.network, others, 1).run(),
        doctest::Contains("process master (ga.master): the window holds 10 samples, but the record has only 9"),
        UserError);
}

TEST_CASE("netlists that run differently have different hashes; an omitted policy is the usual one") {
    auto hash = [](const std::string& parameters) {
        Kinds kinds;
        auto lines = statements();
        for (auto& [name, statement] : lines)
            if (std::size_t at = statement.find("\"line\""); at != std::string::npos)
                statement.replace(at, 6, "\"sphere\"");
        lines.at("master").replace(lines.at("master").find(')'), 1, parameters + ")");
        return read_netlist_text(netlist(lines), kinds.catalogue).network.value().hash;
    };
    CHECK(hash("") != hash(", reproduction = \"tournament\""));
    CHECK(hash("") != hash(", crossover_operator = \"one-point\""));
    CHECK(hash("") != hash(", mutation_operator = \"bit\""));
    CHECK(hash("") ==
          hash(", reproduction = \"usual\", crossover_operator = \"usual\", mutation_operator = \"usual\""));
}

TEST_CASE("real numbers on a processor without a floating-point unit give one warning, unless the netlist states their "
          "cycles") {
    auto said_on = [](const std::string& type, const std::string& cycles) {
        Kinds kinds;
        auto lines = statements();
        for (auto& [name, statement] : lines)
            if (std::size_t at = statement.find("\"line\""); at != std::string::npos && name != "host")
                statement.insert(at + 6, cycles);
        std::string text = netlist(lines).replace(0, 4, type);
        return render(read_netlist_text(text, kinds.catalogue, {}, "farm.cfs").diagnostics);
    };
    for (const char* with_unit : {"T800", "T801", "T805", "B404"})
        CHECK(said_on(with_unit, "").empty());
    for (const char* without : {"T414", "T425", "T400", "T212", "B404_T425"}) {
        CHECK(said_on(without, ", cycles_per_error = 9000").empty());
        std::string said = said_on(without, "");
        CHECK(says(said, "warning: \"master\" computes with real numbers, but \"t\", a T"));
        CHECK(says(said, "has no floating-point unit: cycles_per_error = 1440 is the workload on a T800"));
        CHECK(said.find("warning", said.find("warning") + 1) == std::string::npos);
    }
}
