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
    /// Whether a message has begun to arrive for which no process has asked yet.
    virtual bool message_waits(const AnyChannel&) const = 0;

    // For reports.
    /// Whether the process that outputs (inputs) waits for ever, whatever its partner does: of the message under way
    /// something is lost, or one of them has given it up.
    virtual bool output_is_lost(const AnyChannel&) const { return false; }
    virtual bool input_is_lost(const AnyChannel&) const { return false; }
    /// Whether the other end has given up a message in the middle, and this one is still in it: nothing comes over
    /// until this end is given up and reset, too.
    virtual bool output_must_be_reset(const AnyChannel&) const { return false; }
    virtual bool input_must_be_reset(const AnyChannel&) const { return false; }
    /// What keeps a process that outputs waiting, though its partner inputs: other channels that are to be output at
    /// the same time, or whose message is not taken.
    virtual std::vector<const AnyChannel*> held_up_by(const AnyChannel&) const { return {}; }

    // Of carriers whose messages can be given up (runtime/recovery.hpp).
    /// Behind the channel's name: "travels in packets". "" if they can.
    virtual std::string why_not_given_up() const { return "is on a carrier that takes messages as a whole"; }
    /// The process that is in output (input) goes on without its message: output (input) returns. Returns false, and
    /// does nothing, when the message is over for that process. Called by events; a process is in it.
    virtual bool give_up_output(AnyChannel&) { return false; }
    virtual bool give_up_input(AnyChannel&) { return false; }
    /// Clears the end after that; returns how many bytes of the message had got there. No process is in it.
    virtual std::uint64_t reset_output(AnyChannel&) { return 0; }
    virtual std::uint64_t reset_input(AnyChannel&) { return 0; }
};

} // namespace placedpar
