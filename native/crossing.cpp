#include "native/crossing.hpp"

#include "native/offer.hpp"
#include "runtime/process.hpp"

namespace placedpar::native {

void Crossing::Giver::output(AnyChannel& channel, const WireForm& form, const SourceLocation& where) {
    Process& self = Kernel::here().running();
    c.outputter_ = &self;
    c.offered_bytes_ = static_cast<std::uint64_t>(form.total());
    offer_and_wait(self, channel, where, [this] {
        c.offer_ = Offer::made;
        if (!c.is_posted_.exchange(true))
            c.to_.post(c.offered_);
    });
}

bool Crossing::Giver::give_up_output(AnyChannel&) {
    Offer made = Offer::made;
    if (!c.offer_.compare_exchange_strong(made, Offer::none))
        return false;
    c.outputter_->kernel().make_ready(*c.outputter_);
    return true;
}

void Crossing::Taken::arrive() noexcept {
    c.sent_.add(c.offered_bytes_);
    c.output_.tell_taken_elsewhere();
    c.outputter_->kernel().make_ready(*c.outputter_);
}

/// Claims the message for the inputter, if the outputter offers one: from then on the outputter cannot withdraw it.
/// Returns whether there was an offer.
bool Crossing::claim() {
    Offer made = Offer::made;
    return offer_.compare_exchange_strong(made, Offer::taken);
}

/// Hands the claimed message to the inputter.
void Crossing::take() {
    input_.take_from(output_);
    from_.post(taken_);
}

void Crossing::Taker::input(AnyChannel& channel, const SourceLocation& where) {
    if (std::exchange(c.is_kept_, false) || c.claim())
        return c.take();
    Process& self = Kernel::here().running();
    c.inputter_ = &self;
    self.wait_for(Activity::inputting, &channel, where);
    c.inputter_ = nullptr;
}

bool Crossing::Taker::message_waits(const AnyChannel&) const { return c.is_kept_ || c.offer_ == Offer::made; }

bool Crossing::Taker::keep_message(const AnyChannel&) {
    c.is_kept_ = c.is_kept_ || c.claim();
    return c.is_kept_;
}

bool Crossing::Taker::give_up_input(AnyChannel&) {
    Process* const waiting = std::exchange(c.inputter_, nullptr);
    if (!waiting)
        return false;
    waiting->kernel().make_ready(*waiting);
    return true;
}

void Crossing::Offered::arrive() noexcept {
    c.is_posted_ = false;
    if (!c.inputter_)
        return c.offer_ == Offer::made ? c.input_.announce() : void();
    if (!c.claim())
        return;
    c.take();
    Process* const waiting = std::exchange(c.inputter_, nullptr);
    waiting->kernel().make_ready(*waiting);
}

} // namespace placedpar::native
