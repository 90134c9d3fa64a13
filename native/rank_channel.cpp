#include "native/rank_channel.hpp"

#include "native/offer.hpp"
#include "ranks/rank_mail.hpp"
#include "runtime/process.hpp"
#include "text/user_error.hpp"

#include <fmt/format.h>

#include <utility>

namespace placedpar::native {

namespace {

void require_length(const MessageBytes& packed) {
    if (packed.size() > RankMail::longest_parcel)
        throw UserError(fmt::format("a message of {} bytes is too long for another rank of mpirun, expected at most {}",
                                    packed.size(), RankMail::longest_parcel));
}

} // namespace

void RankGiver::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    bytes_ = static_cast<std::uint64_t>(form.total());
    packed_.clear();
    channel.pack_message(packed_);
    require_length(packed_);
    if (std::exchange(is_awaited_, false)) {
        sent_.add(bytes_);
        channel.tell_taken_elsewhere();
        return member_.send_message(to_, number_, packed_);
    }
    outputter_ = &Kernel::here().running();
    offer_and_wait(*outputter_, channel, where, [this] { member_.send_message(to_, number_, packed_); });
}

void RankGiver::taker_came() {
    Process* const waiting = std::exchange(outputter_, nullptr);
    is_awaited_ = !waiting;
    if (!waiting)
        return;
    sent_.add(bytes_);
    channel_.tell_taken_elsewhere();
    waiting->kernel().make_ready(*waiting);
}

std::string RankGiver::why_not_given_up() const {
    throw UserError("an output to another rank of mpirun cannot be abandoned, because that rank may have the "
                    "message already: place both processes on one rank");
}

/// Sends the outputter the reply that its message will be taken, once for each message.
void RankTaker::promise() {
    if (state_ != State::open)
        return;
    state_ = State::promised;
    member_.send_taker(from_, number_);
}

/// Requests the parcel, that is, the bytes of the message, unless it is already requested or the message has arrived.
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
            return; // the process has given up its input, perhaps just before the message arrived
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
        throw NoMessage("it contains a message that no process can have sent yet");
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
