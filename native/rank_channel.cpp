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

void RankGiver::output(AnyChannel& channel, const WireForm&, const SourceLocation& where) {
    packed_.clear();
    channel.pack_message(packed_);
    require_length(packed_);
    if (std::exchange(is_awaited_, false)) {
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
    channel_.tell_taken_elsewhere();
    waiting->kernel().make_ready(*waiting);
}

std::string RankGiver::why_not_given_up() const {
    throw UserError("an output to another rank of mpirun cannot be given up, since that rank may have the "
                    "message already: place both processes on one rank");
}

/// Sends once for each message that it is taken.
void RankTaker::say_taker() {
    if (!std::exchange(taker_said_, true))
        member_.send_taker(from_, number_);
}

/// Asks for a parcel, unless the message has come.
void RankTaker::ask(Offer& offer) {
    if (!offer.has_come && !std::exchange(offer.is_asked, true))
        member_.expect_parcel(from_, number_, offer.bytes);
}

void RankTaker::input(AnyChannel& channel, const SourceLocation& where) {
    if (count_ > 0 || !channel.is_attempted_input())
        say_taker();
    if (count_ > 0)
        ask(first());
    if (count_ == 0 || !first().has_come) {
        inputter_ = &Kernel::here().running();
        inputter_->wait_for(Activity::inputting, &channel, where);
        if (!taker_said_)
            return; // given up, perhaps just before a message came
    }
    const Offer& taken = first();
    first_ = 1 - first_;
    --count_;
    taker_said_ = false;
    channel.hand_over_packed(taken.packed);
}

bool RankTaker::give_up_input(AnyChannel&) {
    if (!inputter_ || taker_said_)
        return false;
    wake();
    return true;
}

void RankTaker::wake() {
    if (Process* const waiting = std::exchange(inputter_, nullptr))
        waiting->kernel().make_ready(*waiting);
}

void RankTaker::add(bool has_come, std::span<const std::uint8_t> packed, std::size_t bytes) {
    Offer& offer = offers_[(first_ + count_++) % offers_.size()];
    offer.packed.assign(packed.begin(), packed.end());
    offer.bytes = bytes;
    offer.has_come = has_come;
    offer.is_asked = false;
    if (count_ > 1)
        return;
    if (!inputter_)
        return channel_.announce();
    say_taker();
    if (has_come)
        wake();
    else
        ask(offer);
}

void RankTaker::message_came(std::span<const std::uint8_t> packed) {
    if (!is_over_)
        add(true, packed, 0);
}

void RankTaker::parcel_announced(std::size_t bytes) {
    if (is_over_)
        member_.expect_parcel(from_, number_, bytes);
    else
        add(false, {}, bytes);
}

void RankTaker::parcel_came(MessageBytes packed) {
    if (is_over_)
        return;
    first().packed = std::move(packed);
    first().has_come = true;
    wake();
}

void RankTaker::end() {
    is_over_ = true;
    for (std::size_t i = 0; i < count_; ++i)
        ask(offers_[(first_ + i) % offers_.size()]);
}

} // namespace placedpar::native
