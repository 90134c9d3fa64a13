#pragma once

#include "runtime/protocol.hpp"
#include "runtime/source_location.hpp"

#include <cstdint>
#include <string>
#include <vector>

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
    /// Returns whether a message has begun to arrive that no process has asked for yet.
    virtual bool message_waits(const AnyChannel&) const = 0;

    // For reports.
    /// Returns whether the process that outputs (inputs) waits for ever, whatever its partner does: part of the current
    /// message was lost, or one of the two processes has given the message up.
    virtual bool output_is_lost(const AnyChannel&) const { return false; }
    virtual bool input_is_lost(const AnyChannel&) const { return false; }
    /// Returns whether the other end has given up a message that this end is still transferring. Nothing is transferred
    /// until the message is given up and reset at this end, too.
    virtual bool output_must_be_reset(const AnyChannel&) const { return false; }
    virtual bool input_must_be_reset(const AnyChannel&) const { return false; }
    /// Returns what keeps an outputting process waiting although its partner inputs: other channels that must be output
    /// at the same time, or channels whose message has not been taken.
    virtual std::vector<const AnyChannel*> held_up_by(const AnyChannel&) const { return {}; }

    // For carriers whose messages can be given up (runtime/recovery.hpp):
    /// Returns why messages cannot be given up, worded to follow the channel's name: "travels in packets". Returns ""
    /// if they can be given up.
    virtual std::string why_not_given_up() const { return "is on a carrier that takes messages as a whole"; }
    /// Makes output (input) return, so that the process continues without its message. Returns false and does nothing
    /// if the message is already complete for that process. REQUIRES: called by an event, while a process is in output
    /// (input).
    virtual bool give_up_output(AnyChannel&) { return false; }
    virtual bool give_up_input(AnyChannel&) { return false; }
    /// Clears the end after its message was given up; returns how many bytes of the message had been transferred there.
    /// REQUIRES: no process is in output (input) at this end.
    virtual std::uint64_t reset_output(AnyChannel&) { return 0; }
    virtual std::uint64_t reset_input(AnyChannel&) { return 0; }
};

} // namespace placedpar
