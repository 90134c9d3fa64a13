// Tests a coarse and a fine search on the simulated machine against the library's pair.

#include "gaprocs/coarse_fine.hpp"
#include "gaprocs/generation_log.hpp"
#include "gaprocs/recoded_problem.hpp"
#include "runtime/fingerprint.hpp"
#include "tests/gaprocs/cluster.hpp"
#include "tests/nearly.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

using namespace placedpar;

namespace {

constexpr const char* on_one_transputer =
    "T800 t; connect sun.link[0] to t.link[0]; place coarse on t; place fine on t;";
constexpr const char* on_two_transputers =
    "T800 t; T800 (clock = 17500K) u; connect sun.link[0] to t.link[0]; connect sun.link[1] to u.link[0]; "
    "connect t.link[1] to u.link[1]; place coarse on t; place fine on u;";
constexpr const char* fine_on_workstation =
    "T800 t; connect sun.link[0] to t.link[0]; place coarse on t; place fine on sun;";

/// A netlist of a pair for the line problem. The parameters of the coarse search are in line 4, those of the fine
/// search in line 5.
struct PairNetlist {
    std::string placement = on_two_transputers;
    std::string bits_of_coarse = "4", bits_of_fine = "5";
    std::string both = "fields = \"8\", window = 6, first_window = 4, trials = 3, elite = 1, problem = \"line\"";
    std::string coarse = "population = 20", fine = "population = 16";
    std::string host = "problem = \"line\"";
    std::string host_of_fine = "host.to_masters[1]";

    std::string text() const {
        return fmt::format("workstation sun; process host; process coarse; process fine; {}\n"
                           "use \"ga.host\" for host; use \"ga.coarse\" for coarse; use \"ga.fine\" for fine; "
                           "place host on sun; host ({});\n"
                           "connect host.to_masters[0] to coarse.from_host; connect {} to fine.from_host; "
                           "connect coarse.to_fine to fine.from_coarse;\n"
                           "coarse (bits = \"{}\", {}, {});\nfine (bits = \"{}\", {}, {});\n",
                           placement, host, host_of_fine, bits_of_coarse, coarse, both, bits_of_fine, fine, both);
    }
};

/// Returns the library's settings for the netlist.
CoarseFineSettings pair_on_line(Coding coding) {
    SearchSettings coarse;
    coarse.population = 20;
    coarse.elite = 1;
    coarse.window = {.length = 6, .first = 4, .trials = 3};
    SearchSettings fine = coarse;
    fine.population = 16;
    return {coarse, fine, {.problem_bits = {8}, .bits = {4}, .coding = coding}, {5}};
}

/// The results of a pair: for both searches, a hash of all populations and the best of each generation.
struct PairHistory {
    std::string coarse_populations, fine_populations;
    std::vector<double> coarse_bests, fine_bests;
    double slope = 0; ///< answer of the fine search at the end
    bool operator==(const PairHistory&) const = default;
};

void mix_population(Fingerprint& hash, const Search& search) {
    for (const Genome& genome : search.population())
        for (std::uint64_t word : genome.words())
            hash.mix(word);
}

PairHistory history_of_library(const CoarseFineSettings& settings) {
    auto problem = make_search_problem(LineProblem{});
    CoarseFine pair(*problem, settings, 1);
    Fingerprint coarse, fine;
    PairHistory history;
    for (const Sample& sample : line_record(line_samples)) {
        pair.push(sample);
        for (std::size_t trial = 0; pair.ready() && trial < settings.coarse.window.trials; ++trial) {
            mix_population(coarse, pair.coarse());
            mix_population(fine, pair.fine());
            pair.next_generation();
            history.coarse_bests.push_back(pair.coarse_best().fitness);
            history.fine_bests.push_back(pair.fine_best().fitness);
        }
    }
    history.coarse_populations = fmt::format("{:016x}", coarse.value());
    history.fine_populations = fmt::format("{:016x}", fine.value());
    history.slope = problem->decode(pair.fine_best().genome)[0];
    return history;
}

std::vector<double> logged_bests(const GenerationLog& log, std::size_t search) {
    std::vector<double> bests;
    for (const LoggedGeneration& each : log.of(search))
        bests.push_back(each.best);
    return bests;
}

PairHistory history_of_machine(const PairNetlist& netlist) {
    GenerationLog log({"coarse", "fine"}, false);
    RunReport report = run_on_line(netlist.text(), 1, &log);
    CHECK(report.result.ending == Ending::completed);
    return {report.measured_text("coarse", "populations"), report.measured_text("fine", "populations"),
            logged_bests(log, 0), logged_bests(log, 1), report.measured("fine", "slope")};
}

std::string refusal_of_pair(const PairNetlist& netlist) {
    try {
        run_on_line(netlist.text());
    } catch (const std::runtime_error& refused) {
        return refused.what();
    }
    return "";
}

void check_pair_refused(const PairNetlist& netlist, const std::string& place, const std::string& message) {
    std::string refusal = refusal_of_pair(netlist);
    INFO(refusal);
    CHECK_MESSAGE(refusal.find(place) != std::string::npos, place);
    CHECK_MESSAGE(refusal.find(message) != std::string::npos, message);
}

} // namespace

TEST_CASE("a pair of processes makes the library's generations in every placement and coding") {
    for (const char* coding : {"natural", "gray", "natural(1)"})
        for (const char* placement : {on_one_transputer, on_two_transputers, fine_on_workstation}) {
            CAPTURE(coding);
            CAPTURE(placement);
            PairNetlist netlist{placement};
            netlist.both += fmt::format(", coding = \"{}\"", coding);
            PairHistory history = history_of_machine(netlist);
            CHECK(history.fine_bests.size() == 27);
            CHECK(history.slope == test::nearly(152.0 / 256, 0.02));
            CHECK(history == history_of_library(pair_on_line(Coding::named(coding))));
        }
}

TEST_CASE("a coarse search without a fine one stays on its grid") {
    PairNetlist netlist;
    std::string text = netlist.text();
    text.erase(text.find("connect coarse.to_fine"), std::string("connect coarse.to_fine to fine.from_coarse;").size());
    text.replace(text.find("ga.fine"), 7, "ga.coarse");
    RunReport report = run_on_line(text);
    CHECK(report.measured_text("coarse", "populations") == history_of_machine(netlist).coarse_populations);
    double steps = report.measured("coarse", "slope") * 16;
    CHECK(steps == std::floor(steps));
}

TEST_CASE(
    "with an objective, the answer of a pair is the best of all generations, even if the bias point has moved since") {
    PairNetlist netlist;
    netlist.both = "problem = \"valley\", fields = \"4 4\"";
    netlist.bits_of_coarse = "2 2";
    netlist.bits_of_fine = "3 3";
    netlist.host = "problem = \"valley\", generations = 40";
    RunReport report = run_on_line(netlist.text());
    CHECK(report.measured("fine", "best_objective") == 0);
    CHECK(report.measured("fine", "across") == 0);
}

TEST_CASE("a pair whose objective is never a number ends and reports no objective") {
    PairNetlist netlist;
    netlist.both = "problem = \"nowhere\", fields = \"2\"";
    netlist.bits_of_coarse = "1";
    netlist.bits_of_fine = "2";
    netlist.host = "problem = \"nowhere\", generations = 9";
    RunReport report = run_on_line(netlist.text());
    CHECK(report.result.ending == Ending::completed);
    CHECK(report.measured("fine", "generations") == 9);
    CHECK(report.measured_text("fine", "best_objective") == "not a finite number");
}

TEST_CASE("bits and fields that cannot be bred are refused at their place") {
    PairNetlist wrong;
    wrong.bits_of_coarse = "9";
    check_pair_refused(
        wrong, ":4:", "field 1 is bred with 9 bits, expected 1 to 8, the number of bits that it has in the problem");
    wrong.bits_of_coarse = "4 4";
    check_pair_refused(wrong, ":4:", "the problem's string has 1 field, but bits are given for 2");
    for (const char* text : {"", "4.5", "0", "64", "four", "4,4"}) {
        wrong.bits_of_coarse = text;
        check_pair_refused(wrong, ":4:", "expected the number of bits of each field, from 1 to 63 each");
    }
    wrong = {};
    wrong.both = "fields = \"4 4\", problem = \"valley\", coding = \"real\"";
    wrong.host = "problem = \"valley\"";
    wrong.bits_of_coarse = wrong.bits_of_fine = "2 2";
    check_pair_refused(wrong,
                       ":4:", "the searches of a pair breed fields of bits, but real numbers have no such fields");
    wrong = {};
    wrong.both.replace(wrong.both.find("\"8\""), 3, "\"9\"");
    check_pair_refused(wrong, "error", "the fields have 9 bits in all, but the problem's string has 8");
    wrong = {};
    CHECK_THROWS_WITH_AS(RecodedProblem(*minimise(Valley{}), natural_recoding({3, 5})),
                         "the fields of this problem have 4 4 bits, but the recoding states 3 5 bits", UserError);
    wrong.both.replace(wrong.both.find("line"), 4, "seats");
    check_pair_refused(wrong, "error", "host");
}

TEST_CASE("settings of the fine search that differ from those of the coarse search are refused at their place") {
    PairNetlist wrong;
    wrong.both.replace(wrong.both.find(", trials = 3"), 12, "");
    wrong.fine += ", trials = 2";
    check_pair_refused(wrong, ":5:", "trials is 2 for \"fine\", but 5 for \"coarse\"");
    wrong = {};
    wrong.fine += ", coding = \"gray\"";
    check_pair_refused(wrong, ":5:", "coding is gray for \"fine\", but natural for \"coarse\"");
    wrong = {};
    wrong.host_of_fine = "other.to_masters[0]";
    wrong.placement += "process other; use \"ga.host\" for other; other (problem = \"line\"); place other on sun;";
    check_pair_refused(wrong, ":3:", "\"fine\" does not get its samples from the same process as \"coarse\"");
}
