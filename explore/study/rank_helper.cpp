#include "explore/study/rank_helper.hpp"

#include "explore/workers.hpp"
#include "text/paint.hpp"
#include "text/user_error.hpp"

#include <exception>
#include <thread>
#include <utility>

namespace placedpar {

namespace {

/// Throws UserError if this rank has another netlist, other options or another PlacedPar than rank 0, since their
/// results must not be mixed.
void require_same(const Study& study, const std::string& digest) {
    if (digest_of(source_of(study, readable_network(study))) != digest)
        throw UserError("its netlist, its options or its version of PlacedPar differ from those of rank 0; every "
                        "machine must have the same files");
}

} // namespace

void RankHelper::tell(const RankMessage& message) {
    unanswered_ += message.kind == RankMessage::Kind::ask || message.kind == RankMessage::Kind::ended;
    ranks_.send(0, text_of(message));
}

/// Rank 0 begins after reading the study, so that only rank 0 reports errors in the study.
void RankHelper::help(const std::function<Study()>& study, const Interruption& interruption) {
    try {
        RankMessage first = wait_for_message();
        digest_ = first.text;
        if (first.kind == RankMessage::Kind::begin)
            make_runs(study(), interruption);
    } catch (const std::exception& wrong) {
        tell({RankMessage::Kind::failed, unpainted(wrong.what())});
        while (wait_for_message().kind != RankMessage::Kind::stop) {
        }
    }
    tell({RankMessage::Kind::gone});
}

RankMessage RankHelper::wait_for_message() {
    std::optional<Ranks::Message> message;
    while (!(message = ranks_.receive()))
        std::this_thread::sleep_for(rank_patience);
    return rank_message_from(message->text);
}

void RankHelper::make_runs(const Study& study, const Interruption& interruption) {
    require_same(study, digest_);
    for (std::size_t request = 0; request <= jobs_; ++request)
        tell({RankMessage::Kind::ask});
    auto meanwhile = [&] {
        if (interruption.requested())
            stop();
        exchange_messages();
    };
    on_workers(
        jobs_, [&](std::size_t worker) { work(study, worker); }, meanwhile, rank_patience);
    for (exchange_messages(); unanswered_ > 0 && !stopped_; exchange_messages())
        std::this_thread::sleep_for(rank_patience);
}

void RankHelper::work(const Study& study, std::size_t worker) {
    StudyWorker maker(study);
    while (std::optional<StudyRun> run = wait_for_run()) {
        std::optional<StudyOutcome> outcome = maker.outcome_of(*run, interruptions_[worker]);
        if (!outcome)
            return;
        std::lock_guard lock(mutex_);
        ended_.push_back({RankMessage::Kind::ended, "", std::move(run), std::move(outcome)});
    }
}

/// Waits for the next run; returns nothing if no more will come.
std::optional<StudyRun> RankHelper::wait_for_run() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopped_ || !runs_.empty() || no_more_; });
    if (stopped_ || runs_.empty())
        return std::nullopt;
    StudyRun next = std::move(runs_.front());
    runs_.pop_front();
    return next;
}

void RankHelper::exchange_messages() {
    while (std::optional<Ranks::Message> message = ranks_.receive())
        take(rank_message_from(message->text));
    std::vector<RankMessage> ended;
    {
        std::lock_guard lock(mutex_);
        ended.swap(ended_);
    }
    for (const RankMessage& each : ended)
        tell(each);
}

void RankHelper::take(const RankMessage& message) {
    if (message.kind == RankMessage::Kind::stop)
        return stop();
    --unanswered_;
    std::lock_guard lock(mutex_);
    if (message.kind == RankMessage::Kind::run)
        runs_.push_back(*message.run);
    else
        no_more_ = true;
    changed_.notify_all();
}

void RankHelper::stop() {
    {
        std::lock_guard lock(mutex_);
        stopped_ = true;
        changed_.notify_all();
    }
    for (Interruption& each : interruptions_)
        each.request();
}

} // namespace placedpar
