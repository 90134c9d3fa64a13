#include "explore/study/rank_zero.hpp"

#include "text/user_error.hpp"

#include <fmt/format.h>

#include <thread>
#include <utility>

namespace placedpar {

RankZero::RankZero(Ranks& ranks) : ranks_(ranks) {
    for (int rank = 1; rank < ranks.count(); ++rank)
        helping_.insert(rank);
}

RankZero::~RankZero() {
    stop();
    while (!helping_.empty())
        if (auto message = ranks_.receive(); !message)
            std::this_thread::sleep_for(rank_patience);
        else if (rank_message_from(message->text).kind == RankMessage::Kind::gone)
            helping_.erase(message->from);
}

void RankZero::tell_all(const RankMessage& message) {
    for (int rank : helping_)
        ranks_.send(rank, text_of(message));
}

void RankZero::begin(StudySweep& sweep, const StudySource& source) {
    sweep_ = &sweep;
    tell_all({RankMessage::Kind::begin, digest_of(source)});
}

bool RankZero::serve(bool stopped) {
    if (stopped)
        stop();
    while (auto message = ranks_.receive())
        take(rank_message_from(message->text), message->from);
    return !helping_.empty();
}

void RankZero::stop() {
    if (!std::exchange(stopped_, true))
        tell_all({RankMessage::Kind::stop});
}

void RankZero::take(const RankMessage& message, int from) {
    switch (message.kind) {
    case RankMessage::Kind::ended:
        sweep_->keep(*message.run, *message.outcome);
        --in_hand_;
        [[fallthrough]];
    case RankMessage::Kind::ask: return hand_out(from);
    case RankMessage::Kind::gone: helping_.erase(from); return;
    default: throw UserError(fmt::format("rank {}: {}", from, message.text));
    }
}

void RankZero::hand_out(int to) {
    if (stopped_)
        return;
    std::optional<StudyRun> run = sweep_->next();
    in_hand_ += run ? 1 : 0;
    ranks_.send(to, text_of({run ? RankMessage::Kind::run : RankMessage::Kind::none, "", run}));
}

} // namespace placedpar
