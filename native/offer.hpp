#pragma once

#include "runtime/channel.hpp"
#include "runtime/kernel.hpp"
#include "runtime/process.hpp"

namespace placedpar::native {

/// Offers the outputter's message to another kernel by the function `offer`, and waits until it has been taken. If the
/// run is recorded, the wait begins before the offer; otherwise the record could show that the message was taken before
/// its output began. If the run is not recorded, the offer comes first, so that the other kernel need not wait until
/// the clock has been read.
template <class Offer>
void offer_and_wait(Process& self, const AnyChannel& channel, const SourceLocation& where, Offer offer) {
    if (!self.kernel().trace()) {
        offer();
        return self.wait_for(Activity::outputting, &channel, where);
    }
    struct WaitThenOffer final : Communication {
        WaitThenOffer(const AnyChannel& on, const SourceLocation& at, Offer& what)
            : channel(on), where(at), offer(what) {}
        bool begin(Process& process) noexcept override {
            process.begin_wait(Activity::outputting, &channel, where);
            offer();
            return true;
        }
        const AnyChannel& channel;
        const SourceLocation& where;
        Offer& offer;
    } wait(channel, where, offer);
    self.compute_and_communicate(wait, Cycles{0});
}

} // namespace placedpar::native
