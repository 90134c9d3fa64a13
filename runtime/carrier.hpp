#pragma once

#include "runtime/protocol.hpp"
#include "runtime/source_location.hpp"

namespace placedpar {

class AnyChannel;
class Process;

/// What carries a hard channel's messages from one processor to another: a direction of a link, alone or
/// shared with other channels. Both halves return when their process may go on.
class Carrier {
public:
    virtual ~Carrier() = default;

    /// Sends the message that waits in the channel. REQUIRES: called by the outputting process.
    virtual void output(AnyChannel&, const WireForm&, const SourceLocation&) = 0;
    /// Receives a message into the channel's waiting slot. REQUIRES: called by the inputting process.
    virtual void input(AnyChannel&, const SourceLocation&) = 0;
    /// Whether the first byte of a message has arrived that nobody has asked for yet.
    virtual bool message_waits(const AnyChannel&) const = 0;
};

} // namespace placedpar
