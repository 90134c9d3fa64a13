#include "native/rank_channel.hpp"

#include "runtime/process.hpp"
#include "text/user_error.hpp"

#include <utility>

namespace placedpar::native {

void RankGiver::output(AnyChannel& channel, const WireForm&, const SourceLocation& where) {
    packed_.clear();
    channel.pack_message(packed_);
    member_.send_message(to_, number_, packed_);
    if (std::exchange(is_awaited_, false))
        return;
    outputter_ = &Kernel::here().running();
    outputter_->wait_for(Activity::outputting, &channel, where);
}

void RankGiver::taker_came() {
    if (Process* const waiting = std::exchange(outputter_, nullptr))
        waiting->kernel().make_ready(*waiting);
    else
        is_awaited_ = true;
}

std::string RankGiver::why_not_given_up() const {
    throw UserError("an output to another rank of mpirun cannot be given up, since that rank may have the "
                    "message already: place both processes on one rank");
}

/// Sends once for each message that it is taken.
void RankTaker::promise() {
    if (state_ != State::open)
        return;
    state_ = State::promised;
    member_.send_taker(from_, number_);
}

/// Asks for a parcel, unless that has been done or the message has come.
void RankTaker::ask(Offer& offer) {
    if (offer.state != Offer::State::announced)
        return;
    offer.state = Offer::State::expected;
    member_.expect_parcel(from_, number_, offer.bytes);
}

void RankTaker::input(AnyChannel& channel, const SourceLocation& where) {
    if (count_ > 0 || !channel.is_attempted_input())
        promise();
    if (count_ > 0)
        ask(first());
    if (count_ == 0 || first().state != Offer::State::come) {
        inputter_ = &Kernel::here().running();
        inputter_->wait_for(Activity::inputting, &channel, where);
        if (state_ == State::open)
            return; // given up, perhaps just before a message came
    }
    const Offer& taken = first();
    first_ = 1 - first_;
    --count_;
    state_ = State::open;
    channel.hand_over_packed(taken.packed);
}

bool RankTaker::give_up_input(AnyChannel&) {
    if (!inputter_ || state_ != State::open)
        return false;
    wake();
    return true;
}

void RankTaker::wake() {
    if (Process* const waiting = std::exchange(inputter_, nullptr))
        waiting->kernel().make_ready(*waiting);
}

void RankTaker::add(Offer::State state, std::span<const std::uint8_t> packed, std::size_t bytes) {
    if (count_ == offers_.size())
        throw NoMessage("a message that no process can have sent yet");
    Offer& offer = offers_[(first_ + count_++) % offers_.size()];
    offer.packed.assign(packed.begin(), packed.end());
    offer.bytes = bytes;
    offer.state = state;
    if (count_ > 1)
        return;
    if (!inputter_)
        return channel_.announce();
    promise();
    if (state == Offer::State::come)
        wake();
    else
        ask(offer);
}

void RankTaker::message_came(std::span<const std::uint8_t> packed) {
    if (state_ != State::over)
        add(Offer::State::come, packed, 0);
}

void RankTaker::parcel_announced(std::size_t bytes) {
    if (state_ == State::over)
        member_.expect_parcel(from_, number_, bytes);
    else
        add(Offer::State::announced, {}, bytes);
}

void RankTaker::parcel_came(MessageBytes packed) {
    if (state_ == State::over)
        return;
    first().packed = std::move(packed);
    first().state = Offer::State::come;
    wake();
}

void RankTaker::end() {
    state_ = State::over;
    for (std::size_t i = 0; i < count_; ++i)
        ask(offers_[(first_ + i) % offers_.size()]);
}

} // namespace placedpar::native
