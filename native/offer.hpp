#pragma once

#include "runtime/kernel.hpp"
#include "runtime/process.hpp"

namespace placedpar::native {

/// Offers a message to another kernel by the function `offer`, which does not throw, and waits until it has been taken.
/// In a run that is recorded the wait begins before the offer. Otherwise the message might seem to be taken before its
/// output has begun. In other runs the other kernel need not wait for a reading of the clock.
template <class Offer>
void offer_and_wait(Process& self, const AnyChannel& channel, const SourceLocation& where, Offer offer) {
    if (!self.kernel().trace()) {
        offer();
        return self.wait_for(Activity::outputting, &channel, where);
    }
    self.begin_wait(Activity::outputting, &channel, where);
    offer();
    self.wait_on();
}

} // namespace placedpar::native
