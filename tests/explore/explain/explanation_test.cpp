// Tests what `explain` prints about a run: sums, order, and omissions.

#include "explore/explain/explanation.hpp"

#include <boost/json.hpp>
#include <doctest/doctest.h>

#include <string>

using namespace placedpar;
using namespace std::chrono_literals;

namespace {

/// A run of 10 ms without a path; its process computed for 5 ms.
Explanation half_busy() {
    Explanation explanation;
    explanation.report.result.ending = Ending::completed;
    explanation.report.result.time = 10ms;
    explanation.report.processors = {{"t[0]", "T800", 5ms, 0ms}};
    explanation.report.links = {{"t[0].link[1]", "t[1].link[0]", 1000, 2ms}, {"t[1].link[0]", "t[0].link[1]", 0, 0ms}};
    Account account;
    account.computing = 5ms;
    account.waiting = 4ms;
    account.ready = 1ms;
    account.waiting_for["q"] = 3ms;
    explanation.accounts["p"] = account;
    explanation.waits_at_links["t[0].link[1] -> t[1].link[0]"] = 1ms;
    explanation.path_too_long = true;
    return explanation;
}

Answer answer_of(Change::Of of, const std::string& what, const std::string& change, Time time) {
    return {.change = {of, what, change, {{what, "1"}}}, .outcome = RunOutcome::completed, .time = time};
}

std::string printed(const Explanation& explanation) {
    Network network;
    network.source_path = "n.cfs";
    return print_explanation(explanation, network);
}

bool says(const Explanation& explanation, const std::string& text) {
    return printed(explanation).find(text) != std::string::npos;
}

} // namespace

TEST_CASE("a run's first line says how it ended, and when") {
    CHECK(printed(half_busy()).starts_with("n.cfs: completed at 10.000000 ms\n"));
    Explanation stuck = half_busy();
    stuck.report.result.ending = Ending::stuck;
    CHECK(printed(stuck).starts_with("n.cfs: deadlock at 10.000000 ms\n"));
}

TEST_CASE("shares are parts of a process's life and of the run") {
    const std::string text = printed(half_busy());
    CHECK(text.find("p           50.0 %          0.0 %       40.0 %   10.0 %    0.0 %  q (3.000)\n") != text.npos);
    CHECK(text.find("t[0]                            50.0 %    50.0 %\n") != text.npos);
    CHECK(text.find("20.0 %    80.0 %   10.0 %\n") != text.npos);  // the link, and processes waiting to send on it
    CHECK(text.find("t[1].link[0] -> t[0].link[1]") == text.npos); // carried nothing
}

TEST_CASE("a run that took no time has no shares") {
    Explanation nothing;
    nothing.report.processors = {{"t", "T800", 0ms, 0ms}};
    nothing.accounts["p"];
    const std::string text = printed(nothing);
    CHECK(text.find("nan") == text.npos);
    CHECK(text.find("inf") == text.npos);
    CHECK(text.find("\nt" + std::string(32, ' ') + "-") != text.npos);
}

TEST_CASE("the report says why a path was not kept, and what to do") {
    CHECK(says(half_busy(), "critical path: too long to keep: it has more than"));
    CHECK(says(half_busy(), "--until"));
}

TEST_CASE("the gain of a change is shown; changes of little effect are only counted") {
    Explanation explanation = half_busy();
    explanation.answers = {answer_of(Change::Of::all, "all processors", "twice as fast", 5ms),
                           answer_of(Change::Of::all, "all links", "10 % faster", 9'999'999us / 1000),
                           answer_of(Change::Of::constant, "bytes", "half", 10ms)};
    CHECK(says(explanation, "5.000000    50.0 %  all processors twice as fast  [--set all processors=1]\n"));
    CHECK_FALSE(says(explanation, "bytes half"));
    CHECK(says(explanation, "changes that make a difference of less than 0.1 %: 2\n"));
}

TEST_CASE("a slower run is shown with its loss and with a reason why this is possible") {
    Explanation explanation = half_busy();
    Answer slower = answer_of(Change::Of::alone, "processor t[0]", "twice as fast", 12ms);
    slower.why = "+2.000 ms p waits";
    explanation.answers = {slower};
    CHECK(says(explanation, "-20.0 %  processor t[0] twice as fast"));
    CHECK(says(explanation, "slower by +2.000 ms p waits\n"));
    CHECK(says(explanation, "Graham's anomaly"));
}

TEST_CASE("the report says that a change was refused or did not complete") {
    Explanation explanation = half_busy();
    Answer refused = answer_of(Change::Of::constant, "bytes", "none", 0ms), stuck = refused;
    refused.refused = "out of range";
    stuck.outcome = RunOutcome::deadlock;
    explanation.answers = {stuck, refused};
    CHECK(says(explanation, "deadlock  bytes none"));
    CHECK(says(explanation, "refused  bytes none"));
}

TEST_CASE("the report begins with the best change of everything, of a part and of the links, the greatest gain first") {
    Explanation explanation = half_busy();
    explanation.path = {{Activity::computing, "p on t[0]", "t[0]", Time{0}, Time{7ms}},
                        {Activity::carrying, "p.out -> q.in", "", Time{7ms}, Time{10ms}}};
    explanation.answers = {answer_of(Change::Of::all, "all processors", "as fast as can be", 3ms),
                           answer_of(Change::Of::all, "all processors", "twice as fast", 4ms),
                           answer_of(Change::Of::constant, "cycles", "none", 5ms),
                           answer_of(Change::Of::array, "processors of p[]", "twice as fast", 6ms),
                           answer_of(Change::Of::alone, "processor of q", "twice as fast", 7ms),
                           answer_of(Change::Of::number, "one more of slaves:", "3 instead of 2", 8ms),
                           answer_of(Change::Of::all, "all links", "twice as fast", 9ms),
                           answer_of(Change::Of::number, "one more of rows:", "5 instead of 4", 9ms),
                           answer_of(Change::Of::all, "all links", "as fast as can be", Time{9'995us})};
    const std::string text = printed(explanation);
    const std::size_t top = text.find("what holds it back\n"), end = text.find("\n\n", top);
    REQUIRE(top != text.npos);
    CHECK(text.substr(top, end - top) == "what holds it back\n"
                                         "  on the critical path: computing 70.0 %, communicating 30.0 %\n"
                                         "  all processors twice as fast: 60.0 % less time\n"
                                         "  processors of p[] twice as fast: 40.0 % less time\n"
                                         "  one more of slaves: 3 instead of 2: 20.0 % less time\n"
                                         "  one more of rows: 5 instead of 4: 10.0 % less time");
}

TEST_CASE("untried changes are counted, or the report says why no change was tried") {
    Explanation explanation = half_busy();
    explanation.answers = {answer_of(Change::Of::all, "all processors", "twice as fast", 4ms)};
    explanation.left_out = 3;
    CHECK(says(explanation, "changes that were not tried, because the command was interrupted: 3\n"));
    explanation.not_tried = "the run did not complete";
    CHECK(says(explanation, "what if: no change of the machine was tried: the run did not complete\n"));
}

TEST_CASE("the JSON document has the same figures in picoseconds") {
    Explanation explanation = half_busy();
    explanation.answers = {answer_of(Change::Of::all, "all processors", "twice as fast", 4ms)};
    Network network;
    network.source_path = "n.cfs";
    const boost::json::object json = explanation_json(explanation, network);
    CHECK(json.at("time_ps") == 10'000'000'000);
    CHECK(json.at("processes").at(0).at("computing_ps") == 5'000'000'000);
    CHECK(json.at("processes").at(0).at("waiting_for_ps").at("q") == 3'000'000'000);
    CHECK(json.at("processors").at(0).at("idle_ps") == 5'000'000'000);
    CHECK(json.at("links").as_array().size() == 1);
    CHECK(json.at("links").at(0).at("waits_to_ps") == 1'000'000'000);
    CHECK(json.at("what_if").at(0).at("time_ps") == 4'000'000'000);
    CHECK(json.contains("not_kept"));
    CHECK_FALSE(json.contains("not_tried"));
}
