#include "native/rank_channel.hpp"

#include "runtime/process.hpp"

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
    return "leads to another rank of mpirun, which may have its message already";
}

/// Sends once for each message that it is taken.
void RankTaker::say_taker() {
    if (!std::exchange(taker_said_, true))
        member_.send_taker(from_, number_);
}

void RankTaker::fetch_parcel() { member_.expect_parcel(from_, number_, *std::exchange(announced_, std::nullopt)); }

void RankTaker::input(AnyChannel& channel, const SourceLocation& where) {
    if (has_come_ || announced_ || !channel.is_attempted_input())
        say_taker();
    if (announced_)
        fetch_parcel();
    if (!has_come_) {
        inputter_ = &Kernel::here().running();
        inputter_->wait_for(Activity::inputting, &channel, where);
        if (!has_come_)
            return; // given up
    }
    has_come_ = taker_said_ = false;
    channel.hand_over_packed(packed_);
}

bool RankTaker::give_up_input(AnyChannel&) {
    if (!inputter_ || taker_said_)
        return false;
    wake();
    return true;
}

void RankTaker::wake() {
    Process* const waiting = std::exchange(inputter_, nullptr);
    waiting->kernel().make_ready(*waiting);
}

void RankTaker::message_came(std::span<const std::uint8_t> packed) {
    if (is_over_)
        return;
    packed_.assign(packed.begin(), packed.end());
    has_come_ = true;
    if (!inputter_)
        return channel_.announce();
    say_taker();
    wake();
}

void RankTaker::parcel_announced(std::size_t bytes) {
    announced_ = bytes;
    if (!inputter_ && !is_over_)
        return channel_.announce();
    if (!is_over_)
        say_taker();
    fetch_parcel();
}

void RankTaker::parcel_came(MessageBytes packed) {
    if (is_over_)
        return;
    packed_ = std::move(packed);
    has_come_ = true;
    wake();
}

void RankTaker::end() {
    is_over_ = true;
    if (announced_)
        fetch_parcel();
}

} // namespace placedpar::native
