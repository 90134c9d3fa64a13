#pragma once

#include "runtime/channel.hpp"
#include "runtime/kernel.hpp"
#include "runtime/process.hpp"

namespace placedpar::native {

/// Outputs a message to a process on another thread or rank of a native run. Calls `offer`, which offers the message,
/// and waits until the message has been taken. If the run is recorded for a trace, the wait begins before the offer.
/// Otherwise the record could show that the message was taken before its output began. If the run is not recorded, the
/// offer comes first, which is faster for the receiver.
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
