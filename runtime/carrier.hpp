#pragma once

#include "runtime/protocol.hpp"
#include "runtime/source_location.hpp"

namespace placedpar {

class AnyChannel;
class Process;

/// Carries the messages of hard channels from one executive to another: a direction of a link, alone or shared with
/// other channels. output and input return when their process can go on. Each charges its process
/// OperationCosts::hard_communication.
class Carrier {
public:
    virtual ~Carrier() = default;

    /// Sends the message that waits in the channel. REQUIRES: called by the outputting process.
    virtual void output(AnyChannel&, const WireForm&, const SourceLocation&) = 0;
    /// Receives a message into the channel's waiting slot. REQUIRES: called by the inputting process.
    virtual void input(AnyChannel&, const SourceLocation&) = 0;
    /// Whether a message has begun to arrive for which no process has asked yet.
    virtual bool message_waits(const AnyChannel&) const = 0;
};

} // namespace placedpar
