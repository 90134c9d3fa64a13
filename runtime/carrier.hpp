#pragma once

#include "runtime/protocol.hpp"
#include "runtime/source_location.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace placedpar {

class AnyChannel;
class Process;

/// Carries the messages of hard channels from one executive to another. Examples are a direction of a link, a route of
/// packets, and a lane through a bus master's memory. output() and input() return when the calling process can
/// continue. Each call charges the process OperationCosts::hard_communication.
class Carrier {
public:
    virtual ~Carrier() = default;

    /// Sends the message that waits in the channel. REQUIRES: called by the outputting process.
    virtual void output(AnyChannel&, const WireForm&, const SourceLocation&) = 0;
    /// Receives a message into the slot of the process that waits in the channel. REQUIRES: called by the inputting
    /// process.
    virtual void input(AnyChannel&, const SourceLocation&) = 0;
    /// Returns whether a message has begun to arrive and no process has asked for it.
    virtual bool message_waits(const AnyChannel&) const = 0;
    /// Reserves the waiting message for the next input, because an alternation has chosen it. Returns false if the
    /// message has been given up in the meantime. This can happen only on a carrier between threads.
    virtual bool keep_message(const AnyChannel&) { return true; }

    // The next functions are for reports.
    /// Return whether the process that outputs (inputs) waits for ever, whatever its partner does. This is so if part
    /// of the current message was lost, or if one of the two processes has given up the message.
    virtual bool output_is_lost(const AnyChannel&) const { return false; }
    virtual bool input_is_lost(const AnyChannel&) const { return false; }
    /// Return whether the other end has given up a message that this end is still transferring. Nothing is transferred
    /// until this end, too, gives up the message and is reset.
    virtual bool output_must_be_reset(const AnyChannel&) const { return false; }
    virtual bool input_must_be_reset(const AnyChannel&) const { return false; }
    /// Returns the channels that keep an outputting process waiting although its partner inputs. They are other
    /// channels of the same broadcast: the message has not been output on them, or their receiver does not input it.
    virtual std::vector<const AnyChannel*> held_up_by(const AnyChannel&) const { return {}; }
    /// Returns the name of a device that uses one end of the channel in place of a process; "" if processes use both.
    virtual std::string partner_device() const { return ""; }

    // The next functions are for carriers whose messages can be given up (runtime/recovery.hpp).
    /// Returns the reason why messages cannot be given up, or "" if they can. The text follows the channel's name, as
    /// in "travels in packets".
    virtual std::string why_not_given_up() const { return "is on a carrier that transfers only whole messages"; }
    /// Make output (input) return, so that the process continues without its message. Return false and do nothing if
    /// the process's part of the transfer is already complete. REQUIRES: called by an event, while a process is in
    /// output (input).
    virtual bool give_up_output(AnyChannel&) { return false; }
    virtual bool give_up_input(AnyChannel&) { return false; }
    /// Clear the end after its message was given up. Return how many bytes of the message this end has transferred.
    /// REQUIRES: no process is in output (input) at this end.
    virtual std::uint64_t reset_output(AnyChannel&) { return 0; }
    virtual std::uint64_t reset_input(AnyChannel&) { return 0; }
};

} // namespace placedpar
