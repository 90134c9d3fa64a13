#pragma once

#include "runtime/process.hpp"
#include "runtime/time.hpp"

namespace placedpar {

/// Takes the records of a run, in the order in which their stretches of time end. The processes and channels may be
/// gone after the call.
class TraceSink {
public:
    /// The process computed on its executive.
    virtual void computed(const Process&, Time begin, Time end) = 0;
    /// The process waited, as its activity and awaited_channels() say.
    virtual void waited(const Process&, Time begin, Time end) = 0;
    /// A message passed over the channel.
    virtual void communicated(const AnyChannel&, Time at) = 0;

protected:
    ~TraceSink() = default;
};

} // namespace placedpar
