// Tests rank 0 of a sweep and its helpers without MPI: their messages and the results.

#include "explore/study/rank_helper.hpp"
#include "explore/study/rank_zero.hpp"
#include "ranks/rank_mail.hpp"
#include "text/user_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

using namespace placedpar;
using RankKind = RankMessage::Kind;

namespace {

/// Carries messages between ranks, which are threads of this program or the test itself.
class PostOffice {
public:
    explicit PostOffice(std::size_t ranks) : boxes_(ranks) {}

    std::size_t ranks() const { return boxes_.size(); }
    void send(int from, int to, const std::string& text) {
        std::lock_guard lock(mutex_);
        boxes_[static_cast<std::size_t>(to)].push_back({from, text});
    }
    std::optional<Ranks::Message> receive(int own) {
        std::lock_guard lock(mutex_);
        auto& box = boxes_[static_cast<std::size_t>(own)];
        if (box.empty())
            return std::nullopt;
        Ranks::Message first = box.front();
        box.pop_front();
        return first;
    }
    /// Returns all messages that have arrived for this rank.
    std::vector<RankMessage> collect(int own) {
        std::vector<RankMessage> messages;
        while (auto message = receive(own))
            messages.push_back(rank_message_from(message->text));
        return messages;
    }

private:
    std::mutex mutex_;
    std::vector<std::deque<Ranks::Message>> boxes_;
};

class RankByPost final : public Ranks {
public:
    RankByPost(PostOffice& post, int own) : post_(post), own_(own) {}

    int own() const override { return own_; }
    int count() const override { return static_cast<int>(post_.ranks()); }
    void send(int to, const std::string& text) override { post_.send(own_, to, text); }
    std::optional<Message> receive() override { return post_.receive(own_); }
    std::unique_ptr<RankMail> open_mail() override { return nullptr; } // studies need none

private:
    PostOffice& post_;
    int own_;
};

Study three_runs() {
    Study study;
    study.netlist = fmt::format("{}/examples/csp/commstime/commstime.cfs", PLACEDPAR_SOURCE_DIR);
    study.products = {{.axes = {read_axis("count=5,6,7")}}};
    return study;
}

StudySource source_of_three() { return source_of(three_runs(), readable_network(three_runs())); }

std::vector<RankKind> kinds_of(const std::vector<RankMessage>& messages) {
    std::vector<RankKind> kinds;
    for (const RankMessage& each : messages)
        kinds.push_back(each.kind);
    return kinds;
}

/// Rank 0 of three ranks, with helpers played by the test.
struct PlayedHelpers {
    PostOffice post{3};
    RankByPost rank{post, 0};
    Study study = three_runs();
    StudyResults results{StudySource{}};
    StudySweep sweep{study, results};

    void say(int from, const RankMessage& message) { post.send(from, 0, text_of(message)); }
    /// Returns the run that rank 0 has just sent to this helper.
    StudyRun run_for(int helper) {
        const std::vector<RankMessage> messages = post.collect(helper);
        REQUIRE(messages.size() == 1);
        REQUIRE(messages[0].kind == RankKind::run);
        return *messages[0].run;
    }
    void end(int helper, const StudyRun& run) {
        say(helper, {RankKind::ended, "", run, StudyOutcome{.ended = "completed", .time = Time{9}}});
    }
    void leave() {
        say(1, {RankKind::gone});
        say(2, {RankKind::gone});
    }
};

/// Lets the helpers leave at the end, even if the test ends early: rank 0's destructor waits for them.
struct LeavesAtTheEnd {
    PlayedHelpers& played;
    ~LeavesAtTheEnd() { played.leave(); }
};

/// Returns a one-job helper's answers to these messages of rank 0.
std::vector<RankMessage> answers_to(const std::vector<RankMessage>& messages, const Interruption& interruption = {}) {
    PostOffice post(2);
    for (const RankMessage& each : messages)
        post.send(0, 1, text_of(each));
    RankByPost rank(post, 1);
    RankHelper(rank, 1).help(three_runs, interruption);
    return post.collect(0);
}

} // namespace

TEST_CASE("rank 0 hands out each run once, keeps its outcome, and announces the end") {
    PlayedHelpers played;
    RankZero zero(played.rank);
    const LeavesAtTheEnd leaves{played};
    zero.begin(played.sweep, source_of_three());
    for (int helper : {1, 2}) {
        const std::vector<RankMessage> first = played.post.collect(helper);
        REQUIRE(kinds_of(first) == std::vector{RankKind::begin});
        CHECK(first[0].text == digest_of(source_of_three()));
        played.say(helper, {RankKind::ask});
    }
    CHECK(zero.serve(false));
    CHECK(zero.in_hand() == 2);
    const StudyRun first = played.run_for(1), second = played.run_for(2);
    CHECK(first == *played.study.at(0));
    CHECK(second == *played.study.at(1));
    played.end(2, second);
    zero.serve(false);
    CHECK(played.results.count() == 1);
    CHECK(played.results.find(second)->time == Time{9});
    const StudyRun third = played.run_for(2);
    CHECK(third == *played.study.at(2));
    played.end(1, first);
    played.end(2, third);
    played.leave();
    CHECK_FALSE(zero.serve(false));
    CHECK(kinds_of(played.post.collect(1)) == std::vector{RankKind::none});
    CHECK(zero.in_hand() == 0);
    CHECK(played.results.count() == 3);
}

TEST_CASE("a run that a helper leaves unfinished remains counted as handed out") {
    PlayedHelpers played;
    RankZero zero(played.rank);
    const LeavesAtTheEnd leaves{played};
    zero.begin(played.sweep, StudySource{});
    played.say(1, {RankKind::ask});
    played.leave();
    CHECK_FALSE(zero.serve(false));
    CHECK(zero.in_hand() == 1);
    CHECK(played.results.count() == 0);
}

TEST_CASE("a stopped rank 0 announces the stop once and hands out no more runs") {
    PlayedHelpers played;
    RankZero zero(played.rank);
    const LeavesAtTheEnd leaves{played};
    zero.begin(played.sweep, StudySource{});
    played.post.collect(1);
    played.say(1, {RankKind::ask});
    zero.serve(true);
    zero.serve(true);
    CHECK(kinds_of(played.post.collect(1)) == std::vector{RankKind::stop});
    played.leave();
    CHECK_FALSE(zero.serve(true));
}

TEST_CASE("a helper's error is reported with its rank and stops the other helpers") {
    PlayedHelpers played;
    {
        RankZero zero(played.rank);
        const LeavesAtTheEnd leaves{played};
        zero.begin(played.sweep, StudySource{});
        played.say(2, {RankKind::failed, "no such file"});
        CHECK_THROWS_WITH_AS(zero.serve(false), "rank 2: no such file", UserError);
        played.leave();
    }
    CHECK(kinds_of(played.post.collect(1)) == std::vector{RankKind::begin, RankKind::stop});
}

TEST_CASE("a helper requests one run more than it has threads and reports each outcome") {
    const Study study = three_runs();
    const RankMessage none{RankKind::none};
    const std::vector<RankMessage> said = answers_to({{RankKind::begin, digest_of(source_of_three())},
                                                      {RankKind::run, "", study.at(0)},
                                                      {RankKind::run, "", study.at(2)},
                                                      none,
                                                      none});
    REQUIRE(kinds_of(said) ==
            std::vector{RankKind::ask, RankKind::ask, RankKind::ended, RankKind::ended, RankKind::gone});
    StudyWorker alone(study);
    Interruption never;
    for (std::size_t i : {0U, 1U}) {
        const RankMessage& ended = said[2 + i];
        CHECK(*ended.run == *study.at(2 * i));
        CHECK(ended.outcome->fingerprint == alone.outcome_of(*ended.run, never)->fingerprint);
    }
}

TEST_CASE("a helper with other files than rank 0 reports the difference and stops when told to") {
    const std::vector<RankMessage> said = answers_to({{RankKind::begin, "another digest"}, {RankKind::stop}});
    REQUIRE(kinds_of(said) == std::vector{RankKind::failed, RankKind::gone});
    CHECK(said[0].text ==
          "its netlist, its options or its version of PlacedPar differ from those of rank 0; every machine "
          "must have the same files");
}

TEST_CASE("a helper stops immediately if there is no work or if it is interrupted") {
    CHECK(kinds_of(answers_to({{RankKind::stop}})) == std::vector{RankKind::gone});
    Interruption interruption;
    interruption.request();
    const std::vector<RankKind> said =
        kinds_of(answers_to({{RankKind::begin, digest_of(source_of_three())}}, interruption));
    CHECK(said == std::vector{RankKind::ask, RankKind::ask, RankKind::gone});
}

TEST_CASE("a sweep shared among ranks gives the results of an unshared sweep") {
    const Study study = three_runs();
    Interruption never;
    StudyResults alone{StudySource{}}, shared{StudySource{}};
    StudySweep(study, alone).run(1, never, [](std::uint64_t) {});
    PostOffice post(3);
    std::vector<std::jthread> helpers;
    for (int own : {1, 2})
        helpers.emplace_back([&, own] {
            RankByPost rank(post, own);
            RankHelper(rank, 1).help(three_runs, never);
        });
    RankByPost rank(post, 0);
    StudySweep sweep(study, shared);
    RankZero zero(rank);
    zero.begin(sweep, source_of_three());
    sweep.run(
        0, never, [](std::uint64_t) {}, [&](bool stopped) { return zero.serve(stopped); });
    for (std::jthread& each : helpers)
        each.join();
    REQUIRE(shared.count() == 3);
    alone.for_each([&](const StudyRun& run, const StudyOutcome& outcome) {
        const std::optional<StudyOutcome> found = shared.find(run);
        REQUIRE(found);
        CHECK(found->fingerprint == outcome.fingerprint);
        CHECK(figures_text(found->figures) == figures_text(outcome.figures));
    });
}
