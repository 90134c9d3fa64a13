// Tests ga.analyst on the simulated machine against the library's active error analysis.

#include "gaprocs/active_error_analysis.hpp"
#include "gaprocs/generation_log.hpp"
#include "tests/gaprocs/island_netlist.hpp"
#include "tests/sanitized.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <vector>

using namespace placedpar;
using test::IslandNetlist;

namespace {

constexpr std::size_t four = 4;

/// Returns settings of four islands, with windows of 10, 7, 5 and 3 samples.
IslandsSettings nested_windows() {
    IslandsSettings settings;
    settings.islands.resize(four);
    for (std::size_t i = 0; i < four; ++i) {
        settings.islands[i].population = 16 + i;
        settings.islands[i].window.length = std::vector<std::size_t>{10, 7, 5, 3}[i];
        settings.islands[i].window.trials = 2;
    }
    settings.topology = CompleteTopology{};
    return settings;
}

struct Answer {
    std::uint64_t generation;
    std::size_t chosen;
    std::vector<double> values;
    bool operator==(const Answer&) const = default;
};

/// Returns the answers of the library's active error analysis after each exchange.
std::vector<Answer> answers_of_library(const IslandsSettings& settings, const std::string& choice) {
    auto problem = make_search_problem(LineProblem{});
    std::vector<std::size_t> windows;
    for (const SearchSettings& each : settings.islands)
        windows.push_back(each.window.length);
    Islands islands(*problem, settings, island_streams(1, four));
    ActiveErrorAnalysis analysis(*problem, windows, IslandChoice::named(choice), RandomStream(1, "analyst"));
    std::vector<Answer> answers;
    std::vector<Sample> record;
    for (const Sample& sample : line_record(line_samples)) {
        islands.push(sample);
        record.push_back(sample);
        for (std::size_t trial = 0; islands.ready() && trial < 2; ++trial) {
            islands.next_generation();
            if (islands.migrations().empty() || record.size() < 10)
                continue;
            std::vector<Individual> bests;
            for (const Search& search : islands.searches())
                bests.push_back(search.best());
            analysis.analyse(bests, record);
            answers.push_back(
                {islands.searches()[0].generation(), analysis.island(), problem->decode(analysis.answer().genome)});
        }
    }
    return answers;
}

std::string with_analyst(const IslandNetlist& netlist, const std::string& parameters) {
    return netlist.text() +
           fmt::format("process analyst; use \"ga.analyst\" for analyst; analyst ({}); place analyst on sun;\n"
                       "connect host.to_masters[n] to analyst.from_host;\n"
                       "rep i = 0 for n connect island[i].to_analyst to analyst.from_islands[i];\n",
                       parameters);
}

GenerationLog logged(const std::string& netlist) {
    GenerationLog log(island_names(four));
    REQUIRE(run_on_line(netlist, 1, &log).result.ending == Ending::completed);
    return log;
}

std::vector<Answer> answers_of_machine(const IslandNetlist& netlist, const std::string& choice) {
    GenerationLog log = logged(with_analyst(netlist, fmt::format("choice = \"{}\"", choice)));
    std::vector<Answer> answers;
    for (const LoggedAnswer& each : log.answers())
        answers.push_back({each.generation, each.chosen, each.values});
    return answers;
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
    return text.replace(text.find(old), old.size(), by);
}

std::string refusal_of(const std::string& netlist) {
    try {
        run_on_line(netlist);
    } catch (const std::runtime_error& refused) {
        return refused.what();
    }
    return "";
}

} // namespace

TEST_CASE("an analyst gives the library's answers with every choice and in every placement") {
    test::EveryNth sampled(7);
    for (const char* choice : {"printed", "plain", "means", "row", "fixed(2)", "random"})
        for (const char* schedule : {"broadcast(1)", "broadcast(2)", "sequential(1)"})
            for (auto on : {IslandNetlist::On::one_transputer, IslandNetlist::On::four_transputers}) {
                if (sampled.passes_over())
                    continue;
                CAPTURE(choice);
                CAPTURE(schedule);
                IslandNetlist netlist{nested_windows(), on};
                netlist.settings.schedule = Schedule::named(schedule);
                auto answers = answers_of_machine(netlist, choice);
                CHECK(answers.size() >= 3);
                CHECK(answers == answers_of_library(netlist.settings, choice));
            }
}

TEST_CASE("an analyst does not change the islands' generations") {
    IslandNetlist netlist{nested_windows()};
    netlist.settings.schedule = Schedule::named("broadcast(1)");
    RunReport with = run_on_line(with_analyst(netlist, "")), without = run_on_line(netlist.text());
    for (const std::string& island : island_names(four))
        CHECK(with.measured_text(island, "populations") == without.measured_text(island, "populations"));
    CHECK(with.measured("analyst", "answers") == 6); // two generations for each of the samples 10, 11 and 12
    CHECK(with.measured_text("analyst", "chosen").starts_with("island["));
    CHECK(with.measured("analyst", "slope") > 0);
}

TEST_CASE("in the log, an answer comes after the rows of its generation, with the analyst and the chosen island") {
    IslandNetlist netlist{nested_windows()};
    netlist.settings.schedule = Schedule::named("broadcast(1)");
    GenerationLog log = logged(with_analyst(netlist, "choice = \"fixed(2)\""));
    auto rows = log.rows();
    CHECK(rows.back().search == "analyst");
    CHECK(rows.back().from == "island[2]");
    CHECK(rows.back().quantity == "slope");
    CHECK(rows.back().time > rows[rows.size() - 2].time);
}

TEST_CASE("an analysis costs the error evaluations of the longest window, or of all windows if errors depend on them") {
    IslandNetlist netlist{nested_windows()};
    netlist.settings.schedule = Schedule::named("broadcast(1)");
    auto busy = [&](const char* problem, int cycles) {
        std::string text =
            replaced(with_analyst(netlist, fmt::format("cycles_per_error = {}", cycles)), "place analyst on sun",
                     "T800 a; connect a.link[0] to sun.link[3]; connect a.link[1] to t0.link[1]; place analyst on a");
        boost::algorithm::replace_all(text, "\"line\"", problem);
        RunReport report = run_on_line(text);
        for (const auto& processor : report.processors)
            if (processor.name == "a")
                return in_milliseconds(processor.busy);
        return 0.0;
    };
    // Each of 6 answers evaluates the best of 4 islands. An error takes 1000 cycles of 50 ns.
    constexpr double of_a_sample = 6 * 4 * 1000 * 50e-6;
    CHECK(busy("\"line\"", 1000) - busy("\"line\"", 0) == doctest::Approx(of_a_sample * 10).epsilon(0.001));
    CHECK(busy("\"along\"", 1000) - busy("\"along\"", 0) ==
          doctest::Approx(of_a_sample * (10 + 7 + 5 + 3)).epsilon(0.001));
}

TEST_CASE("an analyst that cannot compare its islands is refused at its place in the netlist") {
    IslandNetlist netlist{nested_windows()};
    auto says = [](const std::string& text, const std::string& part, const std::string& marked) {
        std::string refusal = refusal_of(text);
        INFO(refusal);
        CHECK_MESSAGE(refusal.find(part) != std::string::npos, part);
        CHECK_MESSAGE(refusal.find(marked) != std::string::npos, marked);
    };
    says(with_analyst(netlist, "choice = \"fixed(4)\""),
         "the choice is island 4, but the number of islands is 4; expected an island from 0 to 3",
         "choice = \"fixed(4)\"");
    says(with_analyst(netlist, "choice = \"best\""), "\"best\"", "choice = \"best\"");
    netlist.settings.schedule = AsynchronousSchedule{1};
    says(with_analyst(netlist, ""), "islands with an asynchronous schedule are not all in the same generation",
         "process analyst");
    netlist.settings.schedule = Schedule();
    netlist.settings.topology = NoTopology{};
    says(with_analyst(netlist, ""), "\"island[0]\" and \"island[1]\" do not exchange with each other",
         "analyst.from_islands[i]");
    netlist.settings.topology = CompleteTopology{};
    says(replaced(with_analyst(netlist, ""), "connect host.to_masters[n] to analyst",
                  "process other; use \"ga.host\" for other; other (problem = \"line\"); place other on sun; "
                  "connect other.to_masters[0] to analyst"),
         "\"analyst\" does not get its samples from the same process as \"island[0]\"", "analyst.from_host");
}

TEST_CASE("an analyst that would never answer gives a warning at the analyst's place") {
    auto said = [](std::size_t every, const std::string& host = "host (problem = \"line\")") {
        IslandNetlist netlist{nested_windows()};
        netlist.settings.schedule = BroadcastSchedule{every};
        ProblemRegistry problems;
        problems.add("line", make_search_problem(LineProblem{}), line_record(line_samples));
        Catalogue catalogue;
        add_genetic_algorithm_kinds(catalogue, problems);
        auto text = replaced(with_analyst(netlist, ""), "host (problem = \"line\")", host);
        return render(read_netlist_text(text, catalogue, {}, "analyst.cfs").diagnostics);
    };
    // There are 12 samples, with two generations each from the fifth sample on, so 16 generations. The longest window
    // needs ten samples; the 11th generation is the first that has them.
    CHECK(said(16) == "");
    CHECK(said(11) == "");
    std::string never = said(17), early = said(9, "host (problem = \"line\", samples = 9)");
    CHECK(never.find("warning: \"analyst\" gives no answer: the first exchange is due after 17 generations, but the "
                     "run has only 16") != std::string::npos);
    CHECK(early.find("warning: \"analyst\" gives no answer: the last exchange comes after 9 samples, but the longest "
                     "window needs 10") != std::string::npos);
    CHECK(early.find("process analyst;") != std::string::npos);
}

TEST_CASE("an analyst of a problem without a record is refused") {
    std::string text =
        "workstation sun; process h; process i; process a; place h on sun; place i on sun; place a on sun;\n"
        "use \"ga.host\" for h; use \"ga.island\" for i; use \"ga.analyst\" for a;\n"
        "h (problem = \"sphere\"); i (problem = \"sphere\");\n"
        "connect h.to_masters[0] to i.from_host; connect h.to_masters[1] to a.from_host;\n"
        "connect i.to_analyst to a.from_islands[0];\n";
    CHECK(refusal_of(text).find("the problem \"sphere\" has no record of measurements that \"a\" could analyse") !=
          std::string::npos);
    CHECK(refusal_of(replaced(replaced(text, "sphere", "line"), "sphere", "line")) == "");
}
