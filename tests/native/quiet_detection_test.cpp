// Tests the detection of quiet ranks with ranks that send each other messages at random.

#include "native/quiet_detection.hpp"

#include "runtime/random.hpp"
#include "tests/seeds.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

using namespace placedpar;
using native::QuietAnswer;
using native::QuietDetection;

TEST_CASE("ranks without messages are quiet after two rounds") {
    QuietDetection detection(2);
    for (const auto verdict : {QuietDetection::Verdict::again, QuietDetection::Verdict::over}) {
        CHECK_FALSE(detection.is_asking());
        detection.ask();
        CHECK(detection.take(1, {3, 2, false}) == QuietDetection::Verdict::unknown);
        CHECK(detection.is_asking());
        CHECK(detection.take(0, {2, 3, false}) == verdict);
    }
}

TEST_CASE("a process that waits for the end of the work goes on when the ranks are quiet") {
    QuietDetection detection(1);
    const auto asked = [&](const QuietAnswer& answer) {
        detection.ask();
        return detection.take(0, answer);
    };
    CHECK(asked({0, 0, true}) == QuietDetection::Verdict::again);
    CHECK(asked({0, 0, true}) == QuietDetection::Verdict::quiet);
    CHECK(asked({1, 1, false}) == QuietDetection::Verdict::again); // it begins anew
    CHECK(asked({1, 1, false}) == QuietDetection::Verdict::over);
}

namespace {

/// Ranks that are busy or not, messages under way, and questions under way, in any order.
class Chatter {
public:
    Chatter(std::size_t ranks, RandomStream random)
        : random_(std::move(random)), detection_(ranks), ranks_(ranks), is_busy_(ranks, true), counts_(ranks),
          questions_(ranks), messages_(ranks, 0) {}

    /// Returns whether the detection says that the ranks are quiet, and they are then.
    bool ends_rightly() {
        for (int steps = 0; steps < 1'000'000; ++steps)
            if (step() == QuietDetection::Verdict::over)
                return is_quiet();
        return false;
    }
    bool is_quiet() const {
        for (std::size_t i = 0; i < ranks_; ++i)
            if (is_busy_[i] || messages_[i] > 0)
                return false;
        return true;
    }

private:
    QuietDetection::Verdict step() {
        const auto rank = static_cast<std::size_t>(random_.below(static_cast<std::uint32_t>(ranks_)));
        if (is_busy_[rank])
            work(rank);
        else if (messages_[rank] > 0 && random_.chance(0.5))
            receive(rank);
        else if (rank == 0 && !detection_.is_asking())
            ask();
        else if (questions_[rank])
            return answer(rank);
        return QuietDetection::Verdict::unknown;
    }
    void work(std::size_t rank) {
        is_busy_[rank] = random_.chance(0.6);
        if (budget_ == 0 || random_.chance(0.3))
            return;
        --budget_;
        ++counts_[rank].sent;
        ++messages_[static_cast<std::size_t>(random_.below(static_cast<std::uint32_t>(ranks_)))];
    }
    void receive(std::size_t rank) {
        --messages_[rank];
        ++counts_[rank].received;
        is_busy_[rank] = true;
    }
    void ask() {
        detection_.ask();
        questions_.assign(ranks_, true);
    }
    QuietDetection::Verdict answer(std::size_t rank) {
        questions_[rank] = false;
        return detection_.take(rank, counts_[rank]);
    }

    RandomStream random_;
    QuietDetection detection_;
    std::size_t ranks_;
    std::vector<bool> is_busy_;
    std::vector<QuietAnswer> counts_;
    std::vector<bool> questions_;         ///< not answered yet
    std::vector<std::uint64_t> messages_; ///< under way to each rank
    int budget_ = 60;
};

} // namespace

TEST_CASE("the detection never says that ranks are quiet before they are, and always says it then") {
    for (const std::uint64_t seed : test::seeds(3000)) {
        INFO(test::replay(seed));
        Chatter chatter(1 + seed % 5, RandomStream(seed, "chatter"));
        CHECK(chatter.ends_rightly());
    }
}
