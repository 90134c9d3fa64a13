#include "native/rank_clock.hpp"

#include "ranks/ranks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <thread>
#include <utility>

namespace placedpar::native {

namespace {

// 200 questions take less than 1 ms in total if each rank has a core. On a busy machine, one question may take 10 ms.
constexpr int most_questions = 200, least_questions = 5;
constexpr Reading patience = std::chrono::milliseconds(20);
const std::string question = "clock", end_of_questions = "begin";

/// Waits for a text without pausing, since a pause would increase the error.
std::string next_text(Ranks& ranks) {
    for (;;) {
        if (std::optional<Ranks::Message> message = ranks.receive())
            return std::move(message->text);
        std::this_thread::yield(); // another rank may share the core
    }
}

ComparedClock compare_clock_of(int rank, Ranks& ranks) {
    ComparedClock best{.error = Reading::max()};
    const Reading begun = read_clock();
    for (int i = 0; i < most_questions && (i < least_questions || read_clock() - begun < patience); ++i) {
        const Reading asked = read_clock();
        ranks.send(rank, question);
        const Reading there{std::stoll(next_text(ranks))};
        const Reading answered = read_clock(), half = (answered - asked + Reading{1}) / 2;
        if (half < best.error)
            best = {.at = asked + half, .ahead = there - (asked + half), .error = half};
    }
    return best;
}

void answer_questions(Ranks& ranks) {
    while (next_text(ranks) == question)
        ranks.send(0, fmt::format("{}", read_clock().count()));
}

} // namespace

Reading read_clock() {
    return std::chrono::duration_cast<Reading>(std::chrono::steady_clock::now().time_since_epoch());
}

std::vector<ComparedClock> compare_clocks(Ranks& ranks) {
    if (ranks.own() > 0)
        return answer_questions(ranks), std::vector<ComparedClock>{};
    std::vector<ComparedClock> clocks{{.at = read_clock()}};
    for (int rank = 1; rank < ranks.count(); ++rank)
        clocks.push_back(compare_clock_of(rank, ranks));
    for (int rank = 1; rank < ranks.count(); ++rank)
        ranks.send(rank, end_of_questions);
    return clocks;
}

CommonClock::CommonClock(std::vector<ComparedClock> before, std::vector<ComparedClock> after,
                         std::vector<Reading> begun)
    : before_(std::move(before)), after_(std::move(after)), begun_(std::move(begun)),
      first_begun_(begun_by_rank_zero(0)) {
    for (std::size_t rank = 1; rank < begun_.size(); ++rank)
        first_begun_ = std::min(first_begun_, begun_by_rank_zero(rank));
}

Time CommonClock::convert(std::size_t rank, Time since_begun) const {
    const ComparedClock &before = before_[rank], &after = after_[rank];
    const Reading begun = begun_by_rank_zero(rank);
    const auto in_nanoseconds = [](auto time) { return std::chrono::duration<double, std::nano>(time).count(); };
    const double part = in_nanoseconds(begun - before.at + std::chrono::duration_cast<Reading>(since_begun)) /
                        in_nanoseconds(after.at - before.at);
    const std::chrono::duration<double, std::nano> drifted(part * in_nanoseconds(after.ahead - before.ahead));
    const Time converted = Time(begun - first_begun_) + since_begun - std::chrono::round<Time>(drifted);
    return std::max(converted, Time{});
}

std::vector<RankClock> CommonClock::clocks() const {
    std::vector<RankClock> clocks;
    for (std::size_t rank = 1; rank < begun_.size(); ++rank)
        clocks.push_back({fmt::format("rank {}", rank), before_[rank].ahead,
                          Time(std::max(before_[rank].error, after_[rank].error)),
                          Time(after_[rank].ahead - before_[rank].ahead)});
    return clocks;
}

} // namespace placedpar::native
